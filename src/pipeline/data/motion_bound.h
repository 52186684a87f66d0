// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "model/kinematics/joint_path.h"
#include "motion/conservative_advancement.h"

namespace collision_monitor {

/// A joint that moves, between the two links of a pair.
struct ChainJoint {
  LinkId child{};        ///< its axis passes through this link's frame
  Eigen::Vector3d axis;  ///< unit, in the frame of `child`
  bool is_prismatic{false};
  std::size_t path_joint{0};  ///< of JointPath::joints, that moves it
  double factor{1.0};         ///< of a mimic joint: how far it goes for that one
};

/// The joints between two links that the path moves, in order from A to B.
struct LinkChain {
  LinkId a{};
  LinkId b{};
  std::vector<ChainJoint> joints;
};

LinkChain chainBetween(const RobotModel& model, const JointPath& path, LinkId a, LinkId b);

/// By LinkId: a ball that holds all bodies of a link, in its frame.
std::vector<Ball> linkBalls(const CycleSetup& setup);

/// [m] How much nearer two links can come while joints go these ways (by path joint): proven.
///
/// Only joints between the two count. Each turns what lies beyond it about its axis: a point that
/// is at most r from the axis, now and all the while, goes by r times the angle at most, and r
/// grows by what the joints farther out move it. Every joint may as well be taken to turn the one
/// side as the other: the best place to split the chain in two is chosen.
///
/// @param world_from_link at any one time of the motion.
/// Source: Schwarzer, Saha, Latombe, "Adaptive Dynamic Collision Checking for Single and Multiple
/// Articulated Robots in Complex Environments" (2005), section IV; departs from it in taking the
/// lever arms from the present pose instead of from the worst one, and in splitting the chain.
double boundMotion(const LinkChain& chain, const std::vector<Ball>& balls,
                   const std::vector<Pose>& world_from_link,
                   const std::vector<double>& travels) noexcept;

}  // namespace collision_monitor
