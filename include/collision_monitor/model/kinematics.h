// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// Joint variables of every robot, in the order of Joint::first_variable.
using JointPositions = std::vector<double>;

/// Zero, moved to the nearest limit where zero is outside; identity for floating joints.
JointPositions defaultPositions(const RobotModel& model);

/// Pose of a joint's child link for its variables: parent_from_child.
Pose parentFromChild(const Joint& joint, const JointPositions& positions) noexcept;

/// Poses of all links, each robot's root placed by `world_from_root` (one a robot).
/// Does not allocate when `world_from_link` has the right size.
void placeLinks(const RobotModel& model, const JointPositions& positions,
                const std::vector<Pose>& world_from_root, std::vector<Pose>& world_from_link);

}  // namespace collision_monitor
