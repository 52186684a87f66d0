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
/// Frames: `parent_from_child` joins the frames of a joint's two links; URDF puts
/// the child's frame at the joint. World frame where the name says so.
/// Units: metres and radians.
/// Limits: a position that is NaN or infinite gives poses that are not finite, for
/// the link and all that hang on it, and no error: isFinite tells.
/// Source: Featherstone, "Rigid Body Dynamics Algorithms" (2008), section 4.4 on
/// joint models; the URDF specification of joints (wiki.ros.org/urdf/XML/joint).

/// Joint variables of every robot, in the order of Joint::first_variable.
using JointPositions = std::vector<double>;

/// Zero, moved to the nearest limit where zero is outside; identity for floating joints.
JointPositions defaultPositions(const RobotModel& model);

/// Pose of a joint's child link for its variables.
///
/// Revolute and continuous joints turn about `axis`, prismatic ones move along it.
/// A planar joint moves by (x, y) in the plane normal to `axis` and then turns
/// about `axis`. URDF does not say which way x and y point in the plane: here they are the x
/// and y of the joint frame turned by the least rotation that takes z onto `axis`
/// (about x, by half a turn, if `axis` is -z). So a planar joint about z, as MoveIt has them
/// all, has the x and y of its own frame.
/// A floating joint's quaternion is normalised; one of zeros gives a pose that is not finite.
/// @pre `positions` has all variables of the joint's model.
Pose parentFromChild(const Joint& joint, const JointPositions& positions) noexcept;

/// Poses of all links, each robot's root placed by `world_from_root` (one a robot).
/// Does not allocate when `world_from_link` has the right size.
/// @pre `positions` has RobotModel::variable_count entries, `world_from_root` one a robot.
void placeLinks(const RobotModel& model, const JointPositions& positions,
                const std::vector<Pose>& world_from_root, std::vector<Pose>& world_from_link);

/// Poses of all links in the default positions, each robot's root at the world's origin.
std::vector<Pose> defaultPoses(const RobotModel& model);

/// In how many ways the joint's child can move: revolute, continuous, prismatic 1 (mimic joints
/// too: with their source); planar 3; floating 6; fixed 0.
std::size_t freedomOf(const Joint& joint) noexcept;

/// How the child moves against its parent for a unit of one velocity of the joint; the velocities
/// are those of its variables, and the k-th belongs to variable `first_variable + k`. A floating
/// joint has, in place of its quaternion's derivatives, turns about x, y and z of the joint frame
/// through the child's origin, as variables 3 to 5. A mimic joint moves by its multiplier for a
/// unit of its source.
/// Frames: world, for given poses of the joint's links.
/// Source: Featherstone (2008), section 3.5: the columns of a joint's motion subspace.
/// @pre k < freedomOf(joint)
Twist jointTwist(const Joint& joint, std::size_t k, const Pose& world_from_parent,
                 const Pose& world_from_child) noexcept;

/// What messages call each velocity, by the index of its variable: the joint's name, with an
/// ending for planar (x, y, theta) and floating joints (trans_x to trans_z, turn_x to turn_z).
std::vector<std::string> velocityNames(const RobotModel& model);

}  // namespace collision_monitor
