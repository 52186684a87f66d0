// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// The fault of a request that names an unknown link. It tells a link with shapes of a similar
/// name, or which are accepted.
std::string noSuchLink(const RobotModel& model, const std::string& field, const std::string& name);

}  // namespace collision_monitor
