// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/pipeline/setup.h"
#include "model/kinematics/joint_path.h"
#include "pipeline/data/cycle_data.h"

/// Whether links touch on a way that joints are to go, and how near they come: for the whole way,
/// not for samples of it.
namespace collision_monitor {

struct TrajectoryOptions {
  /// [m] Pairs that come nearer are near misses, whose nearest approach is searched for; of the
  /// others it is only proven that they stay farther apart. 0 or less: contacts alone are searched
  /// for, which is faster.
  double margin{0.05};
  double resolution{1e-3};  ///< [m] so much nearer than found may a near miss come
  double tolerance{1e-6};   ///< [m] this much beyond contact_distance is contact
  /// Steps, as RefineLimits::budget; each link placed and each pair looked at in a part is one,
  /// too.
  std::uint64_t budget{std::numeric_limits<std::uint64_t>::max()};
  /// Told the share that is done, which grows, after each way-point and where there is much to do
  /// between two; false ends the search. May be empty.
  std::function<bool(double done)> progress;
};

enum class ApproachState : unsigned char {
  clear,      ///< no contact on the whole way: proven
  contact,    ///< first at `time`, clear before: proven
  undecided,  ///< the budget or `progress` ended the search; clear up to `time`
  unknown,    ///< how the links stand to each other is unknown, or the path is not sound
};

/// Of one pair of links.
struct PairApproach {
  ApproachState state{ApproachState::unknown};
  double time{0.0};  ///< [s] of `nearest`; undecided: up to where it is clear
  /// The nearest that was measured; in contact, the first. Points are those of that time. Where
  /// contacts alone were searched for, it may be a bound that is raised and has no points.
  PairDistance nearest;
  double at_least{0.0};  ///< [m] proven: at no time nearer, up to the contact if there is one
};

struct TrajectoryReport {
  std::vector<PairApproach> pairs;     ///< by LinkPairIndex
  LinkPairIndex first_contact{kNone};  ///< the pair that touches first, or kNone
  std::vector<Pose> world_from_link;   ///< then
  std::uint64_t work{0};               ///< spent
};

/// Follows every checked pair of links along the path.
///
/// Where two links stand at both ends of a part of the way, and how far they can come nearer in
/// between (boundMotion), bounds their distance on all of it; a part that leaves open what is asked
/// is halved. Balls, enclosing shapes, hulls and the geometries themselves are asked in this order,
/// and searches stop at what settles the part. Of many way-points the shapes are measured several
/// way-points at once; the geometries of what may be a near miss are where these are nearest, so
/// that what stays farther apart need not be measured. Far pairs are settled over several segments.
///
/// Error: `time` of a contact is where the pair is within `tolerance` of contact_distance, and up
/// to there nothing was nearer. `at_least` holds but for rounding.
/// Limits: meshes inside each other without touching surfaces are contacts if they are closed.
/// Source: Schwarzer, Saha, Latombe (2005), section III, for the bound of both ends and the
/// halving.
/// @param start poses of all links, the path's joints at its first way-point: they say where links
/// are that the path does not move.
TrajectoryReport checkTrajectory(const CycleSetup& setup, const JointPath& path,
                                 const LinkPoses& start, const TrajectoryOptions& options);

}  // namespace collision_monitor
