// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "model/kinematics/joint_path.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {

/// Distances of the enclosing shapes of link pairs at the way-points of a path. Holds some blocks
/// of way-points; the way-points of a block are measured at once.
struct WaypointDistances {
  double reach;  ///< [m] larger distances are not measured
  StatesWork work;
  JointPositions positions;  ///< of all way-points, as in checkStates
  /// By block and LinkPairIndex.
  std::vector<std::vector<StateNumber>> nearest;
  std::size_t first{0};  ///< first way-point of the blocks
  std::size_t last{0};   ///< end of the blocks
};

/// @param start as in checkTrajectory
WaypointDistances makeWaypointDistances(const CycleSetup& setup, const JointPath& path,
                                        const LinkPoses& start, double reach);

/// Measures these pairs in blocks from that of the way-point on, unless the blocks hold it.
/// @return work as in RefineLimits::budget: a pair of bodies counts one for each block.
std::uint64_t measureWaypoint(const CycleSetup& setup, const std::vector<LinkPairIndex>& pairs,
                              std::size_t waypoint, WaypointDistances& distances) noexcept;

/// [m] The distance, at most `reach`; NaN if a link is not known.
/// @pre the blocks hold the way-point.
inline double distanceAt(const WaypointDistances& distances, std::size_t waypoint,
                         LinkPairIndex pair) noexcept {
  const std::size_t place = waypoint - distances.first;
  return distances.nearest[place / kStateCount][pair].of[place % kStateCount];
}

}  // namespace collision_monitor
