// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/pair_search/joint_ranges.h"

/// How the joints between two links move one against the other, and cells of their ranges.
namespace collision_monitor {

/// A joint between two links, A and B.
struct PairJoint {
  LinkId child{};        ///< its axis passes through this link's frame
  Eigen::Vector3d axis;  ///< unit, in the frame of `child`
  bool is_prismatic{false};
  bool carries_b{false};    ///< B is on the child's side of the joint; else A is
  std::size_t variable{0};  ///< index into PairMotion::ranges of the range that moves it
  double factor{1.0};       ///< of a mimic joint: its multiplier, with its sign
};

struct PairMotion {
  LinkId a{};
  LinkId b{};
  std::vector<PairJoint> joints;   ///< those that move, in order from A to B
  std::vector<JointRange> ranges;  ///< of the joints that move them, each once
  std::vector<LinkId> links;       ///< those that a state places, parents first
  bool is_whole{false};            ///< `ranges` cover every motion of A against B
  double scale{0.0};               ///< [m] about the length of the chain, for rounding
};

/// @param ranges from jointRanges.
PairMotion makePairMotion(const RobotModel& model, const std::vector<JointRange>& ranges, LinkId a,
                          LinkId b);

/// A box of joint values: by variable of a PairMotion, its middle and half width.
struct JointCell {
  std::vector<double> middle;
  std::vector<double> half;
  std::vector<std::uint32_t> open;  ///< what is still to be proven in it; see the proofs
};

/// All of the ranges.
JointCell wholeCell(const PairMotion& motion);

/// A half of a cell, cut across a variable.
/// @param side -1 or 1
JointCell halfOf(const JointCell& cell, std::size_t variable, double side);

/// The middle of a cell, with links and joint axes in the world frame.
struct PlacedCell {
  const PairMotion& motion;
  JointPositions state;                 ///< of the whole model; other joints stand as by default
  std::vector<Pose> world_from_link;    ///< by LinkId; only those of PairMotion::links move
  std::vector<Eigen::Vector3d> axes;    ///< by joint: unit
  std::vector<Eigen::Vector3d> points;  ///< by joint: a point of its axis
  std::vector<double> halves;           ///< by joint: [rad] or [m] to both sides of the middle
};

/// Places the default state.
PlacedCell makePlacedCell(const RobotModel& model, const PairMotion& motion,
                          const std::vector<Pose>& world_from_root);

void place(const RobotModel& model, const JointCell& cell, PlacedCell& placed);

}  // namespace collision_monitor
