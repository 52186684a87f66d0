// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <trajectory_msgs/JointTrajectory.h>

#include <string>
#include <vector>

#include "model/kinematics/joint_path.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// A trajectory as a path, and the poses it starts from: `start` is changed to its first point.
/// @return what is wrong with the trajectory, each with what is accepted; empty if nothing is.
std::vector<std::string> readTrajectory(const RobotModel& model,
                                        const trajectory_msgs::JointTrajectory& trajectory,
                                        JointPath& path, LinkPoses& start);

/// Puts the way to the first point before it, where its time is not 0: at time 0 the path leaves
/// from where its joints are now, with velocity 0 if it has velocities. `start` is changed to
/// there.
/// @return the joints whose positions now are not known; if there are any, nothing is changed.
std::vector<std::string> addWayToFirstPoint(const RobotModel& model, const NewestState& newest,
                                            JointPath& path, LinkPoses& start);

}  // namespace collision_monitor
