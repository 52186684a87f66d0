// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <trajectory_msgs/JointTrajectory.h>

#include <string>
#include <vector>

#include "collision_monitor/model/joint_path.h"
#include "collision_monitor/pipeline/cycle_data.h"

namespace collision_monitor {

/// A trajectory as a path, and the poses it starts from: `start` is changed to its first point.
/// @return what is wrong with the trajectory, each with what is accepted; empty if nothing is.
std::vector<std::string> readTrajectory(const RobotModel& model,
                                        const trajectory_msgs::JointTrajectory& trajectory,
                                        JointPath& path, LinkPoses& start);

}  // namespace collision_monitor
