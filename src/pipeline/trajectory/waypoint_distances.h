// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "model/kinematics/joint_path.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {

/// How far the enclosing shapes of links are apart at the way-points of a path: of some blocks of
/// states at hand, each as many way-points at once as it holds.
struct WaypointDistances {
  double reach;  ///< [m] farther apart is not measured
  StatesWork work;
  JointPositions positions;  ///< of all way-points, as for checkStates
  /// By LinkPairIndex, of the blocks at hand.
  std::vector<std::vector<StateNumber>> nearest;
  std::size_t first{0};  ///< way-point of these blocks
  std::size_t last{0};   ///< behind them
};

/// @param start as for checkTrajectory
WaypointDistances makeWaypointDistances(const CycleSetup& setup, const JointPath& path,
                                        const LinkPoses& start, double reach);

/// Measures these pairs in the blocks from that of the way-point on, unless it is at hand.
/// @return steps, as RefineLimits::budget: a pair of bodies is one for the block.
std::uint64_t measureWaypoint(const CycleSetup& setup, const std::vector<LinkPairIndex>& pairs,
                              std::size_t waypoint, WaypointDistances& distances) noexcept;

/// [m] The reach, where that is less; NaN where a link is not known.
/// @pre the way-point is at hand.
inline double distanceAt(const WaypointDistances& distances, std::size_t waypoint,
                         LinkPairIndex pair) noexcept {
  const std::size_t place = waypoint - distances.first;
  return distances.nearest[place / kStateCount][pair].of[place % kStateCount];
}

}  // namespace collision_monitor
