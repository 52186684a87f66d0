// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pipeline/refine/sweep_pairs.h"

/// What a cycle asks of every checked pair of links, in one walk: links stand in columns, and each
/// is joined with several neighbours at once.
namespace collision_monitor {

/// A link and those in the slots from `pairs.first` on; pairs are LinkPairIndices.
struct LinkBlock {
  PairBlock pairs;
  /// [m] by lane: as thicknessOfPairs; infinite across two parts
  alignas(64) double thickness[kBlockLanes] = {};
};

/// The columns of links, world frame, [m] and [s] or steps.
namespace link_column {
constexpr std::size_t center = 0;        ///< of its ball, x, y, z
constexpr std::size_t radius = 3;        ///< of its ball
constexpr std::size_t velocity = 4;      ///< a twist: linear, angular; NaN where it is not known
constexpr std::size_t travel = 10;       ///< how far any point of the ball has come at most
constexpr std::size_t last_center = 11;  ///< in the last cycle
constexpr std::size_t moved = 14;        ///< a twist per step: how it has come since
constexpr std::size_t bent = 20;         ///< a twist per step: how far that way may leave the screw
constexpr std::size_t count = 26;
}  // namespace link_column

/// How near bodies must be to matter to any stage, and what is needed to say so.
struct ActivationDistances {
  // Made at set-up.
  std::vector<LinkId> links;  ///< by slot: those that stand in checked pairs
  std::vector<Ball> balls;    ///< by slot: as linkBalls
  std::vector<LinkBlock> blocks;
  std::vector<double> thickness;  ///< [m] by LinkPairIndex: as thicknessOfPairs
  double contact{0.0};            ///< [m] contact_distance
  double stop{0.0};               ///< [m] at least that, and what scaleSpeed must hear of
  bool is_split{false};           ///< links stand in several parts

  BodyRows rows;                ///< of the links
  std::vector<double> of_pair;  ///< [m] by LinkPairIndex
  /// [m] By LinkPairIndex: the same without what is only reported. Farther bodies matter only if
  /// they are the nearest of two elements.
  std::vector<double> near_of_pair;
};

ActivationDistances makeActivationDistances(const CycleSetup& setup);

/// [m] By LinkPairIndex: how thick two bodies are together where they are thinnest, the least of
/// all bodies of two links. Two without thickness overlap at no time, so they do not count.
std::vector<double> thicknessOfPairs(const CycleSetup& setup);

/// How near bodies of each pair of links must be to be reported, to be refined, to touch within the
/// horizon or to ask for less than full speed at today's velocities, or to have touched since the
/// last cycle. Infinite where a velocity is not known.
///
/// A distance changes by the motion of one of the nearest points seen from the other link, so no
/// faster than the ball of B's bodies moves seen from A.
///
/// Fills `sweep.step`, too, if time has passed. What passes through something in a step comes
/// farther, seen from it, than both are thick. Where poses alone are looked at, links come as far
/// as their twists say. Where the way between two cycles is looked at, only what leaves their
/// screws is unseen: an even acceleration that changes the way of a step by w against that of the
/// last one bends the path by w / 8.
/// Pairs across two parts have no limit: how they move past each other is not known.
/// Error: limits of steps are estimates, for the twists of one time stand for a whole step. The
/// same bytes with every instruction set.
/// @pre `sweep` is that of findMotions.
void findActivationDistances(const CycleSetup& setup, const LinkPoses& poses, SweepWork& sweep,
                             ActivationDistances& reaches) noexcept;

}  // namespace collision_monitor
