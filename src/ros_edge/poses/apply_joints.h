// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/JointState.h>

#include <string>
#include <vector>

#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// What is wrong with a position or velocity of a joint: "is not finite"; empty if nothing is.
std::string numberFault(double number);

/// What is wrong with `joints`: a few sentences and how many more, in time linear in the names.
std::vector<std::string> jointFaults(const RobotModel& model,
                                     const sensor_msgs::JointState& joints);

/// Moves the named joints, and those that mimic them, to the given positions; all other joints
/// stay where `poses` has them. Fixed joints are taken from the model where `poses` does not
/// know them, so that a robot whose moving joints are all named is one part, wherever its root is.
/// What neither places begins a part that floats.
/// @return as jointFaults: `poses` are unchanged if there are any.
std::vector<std::string> applyJoints(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     LinkPoses& poses);

}  // namespace collision_monitor
