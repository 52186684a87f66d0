// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"
#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// The world that changes start from: that of the set-up, and objects that it holds back where the
/// changes remove these.
/// @param held_back becomes those that stay held back. A list that is cleared or replaced no longer
/// waits for objects of the parameters.
World worldBefore(const std::vector<ObjectChange>& changes, const MonitorSetup& current,
                  std::vector<WorldObject>& held_back);

}  // namespace collision_monitor
