// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// By LinkId: the first link of its rigid group, the links that only fixed joints join.
std::vector<LinkId> findRigidGroups(const RobotModel& model);

}  // namespace collision_monitor
