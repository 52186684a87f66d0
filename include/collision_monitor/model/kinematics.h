// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/geometry/twist.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// Forward kinematics of the forest of links.
///
/// Frames: `parent_from_child` relates the frames of a joint's two links. URDF puts the child's
/// frame at the joint. World frame where the name says so.
/// Units: metres and radians.
/// Limits: a position that is NaN or infinite gives poses that are not finite, for the link and all
/// links below it. There is no error; isFinite tells.
/// Source: Featherstone, "Rigid Body Dynamics Algorithms" (2008), section 4.4 on joint models; the
/// URDF specification of joints (wiki.ros.org/urdf/XML/joint).

/// Joint variables of every robot, in the order of Joint::first_variable.
using JointPositions = std::vector<double>;

/// Zero, or the nearest limit where zero is outside the limits; identity for floating joints.
JointPositions defaultPositions(const RobotModel& model);

/// Pose of a joint's child link for its variables.
///
/// Revolute and continuous joints turn about `axis`. Prismatic joints move along it. A planar joint
/// moves by (x, y) in the plane normal to `axis` and then turns about `axis`. URDF does not define
/// the directions of x and y in the plane. Here they are the x and y axes of the joint frame,
/// turned by the smallest rotation that takes z onto `axis` (half a turn about x if `axis` is -z).
/// A planar joint about z, the only kind in MoveIt, therefore uses the x and y of its own frame.
/// A floating joint's quaternion is normalised. A quaternion of zeros gives a pose that is not
/// finite.
/// @pre `positions` has all variables of the joint's model.
Pose parentFromChild(const Joint& joint, const JointPositions& positions) noexcept;

/// Poses of all links. `world_from_root` places the root of each robot.
/// Does not allocate when `world_from_link` has the right size.
/// @pre `positions` has RobotModel::variable_count entries, `world_from_root` has one per robot.
void placeLinks(const RobotModel& model, const JointPositions& positions,
                const std::vector<Pose>& world_from_root, std::vector<Pose>& world_from_link);

/// Poses of all links in the default positions, each robot's root at the world's origin.
std::vector<Pose> defaultPoses(const RobotModel& model);

/// Number of degrees of freedom of the joint's child: 1 for revolute, continuous and prismatic
/// joints (a mimic joint too: it moves with its source), 3 for planar, 6 for floating, 0 for fixed.
std::size_t freedomOf(const Joint& joint) noexcept;

/// Twist of the child relative to its parent for a unit of one joint velocity. Velocity k is the
/// derivative of variable `first_variable + k`. A floating joint differs in variables 3 to 5: they
/// are rotations about x, y and z of the joint frame through the child's origin, not the
/// derivatives of its quaternion. A mimic joint moves by its multiplier for a unit of its source.
/// Frames: world, for given poses of the joint's links.
/// Source: Featherstone (2008), section 3.5: the columns of a joint's motion subspace.
/// @pre k < freedomOf(joint)
Twist jointTwist(const Joint& joint, std::size_t k, const Pose& world_from_parent,
                 const Pose& world_from_child) noexcept;

/// Name of each velocity in messages, by the index of its variable: the joint's name, plus an
/// ending for planar (x, y, theta) and floating joints (trans_x to trans_z, turn_x to turn_z).
std::vector<std::string> velocityNames(const RobotModel& model);

}  // namespace collision_monitor
