// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/model/limits.h"
#include "collision_monitor/model/problems.h"

/// Numbers of the command line, as NAME=VALUE.
namespace collision_monitor::explain_tool {

/// The default limits with those that the texts set.
Limits readLimits(const std::vector<std::string>& texts, SetupReport& report);

/// Moves the joints that the texts name. Warns of positions beyond their limits.
void readJoints(const RobotModel& model, const std::vector<std::string>& texts,
                JointPositions& positions, SetupReport& report);

}  // namespace collision_monitor::explain_tool
