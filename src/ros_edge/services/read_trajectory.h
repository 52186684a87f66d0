// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <trajectory_msgs/JointTrajectory.h>

#include <string>
#include <vector>

#include "model/kinematics/joint_path.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// Reads a trajectory as a path. Changes `start` to the poses at its first point.
/// @return the faults, each with what is accepted; empty if there are none.
std::vector<std::string> readTrajectory(const RobotModel& model,
                                        const trajectory_msgs::JointTrajectory& trajectory,
                                        JointPath& path, LinkPoses& start);

/// If the first point's time is not 0, adds the motion to it. The path then begins at time 0 at the
/// joints' current positions, with velocity 0 if it has velocities. `start` becomes that state.
/// @return the joints whose current positions are unknown; if there are any, nothing is changed.
std::vector<std::string> addWayToFirstPoint(const RobotModel& model, const NewestState& newest,
                                            JointPath& path, LinkPoses& start);

}  // namespace collision_monitor
