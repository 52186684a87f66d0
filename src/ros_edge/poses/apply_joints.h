// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/JointState.h>

#include <string>
#include <vector>

#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// The fault of a joint's position or velocity: "is nan; accepted: -1e9 to 1e9"; empty if there is
/// none.
std::string numberFault(double number);

/// Whether a request can give the position of some joint.
bool takesPositions(const RobotModel& model);

/// Faults of `joints`: a few sentences and the number of others. The time is linear in the names.
/// @param names  the request's field that holds the names, for messages; positions that may have
///               faults stand in `joints.position`
std::vector<std::string> jointFaults(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     const std::string& names);

/// Moves the named joints and their mimic joints to the given positions. All other joints stay
/// where `poses` has them. Fixed joints that `poses` does not know come from the model, so a robot
/// with all its moving joints named is one part, wherever its root is. A link that nothing places
/// begins a floating part.
/// @return as jointFaults: if there are any, `poses` is unchanged.
std::vector<std::string> applyJoints(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     const std::string& names, LinkPoses& poses);

}  // namespace collision_monitor
