// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/pipeline/setup.h"
#include "collision_monitor/pipeline/trajectory_options.h"
#include "model/kinematics/joint_path.h"
#include "pipeline/data/cycle_data.h"

/// Checks whether links touch on a joint path, and how near they come: proven for the whole path,
/// not only for samples of it.
namespace collision_monitor {

/// The approach of one link pair.
struct PairApproach {
  ApproachState state{ApproachState::unknown};
  double time{0.0};  ///< [s] of `nearest`; undecided: until when it is clear
  /// The nearest measurement; in contact, the first contact. Its points are those at `time`. If
  /// only contacts are searched for, it may be a raised bound; its points are those of bodies.
  PairDistance nearest;
  double at_least{0.0};  ///< [m] proven lower bound of the distance, until the contact if any
};

struct TrajectoryReport {
  std::vector<PairApproach> pairs;     ///< by LinkPairIndex
  LinkPairIndex first_contact{kNone};  ///< the link pair of the first contact, or kNone
  std::vector<Pose> world_from_link;   ///< at the first contact
  std::uint64_t work{0};               ///< work done
};

/// Follows every checked link pair along the path.
///
/// The distances of two links at both ends of a part of the path, and how much nearer they can come
/// between these (boundMotion), bound their distance in the whole part. A part that this does not
/// settle is halved. Measures balls, enclosing shapes, hulls and geometries, in this order, and
/// stops when the part is settled. Before meshes are measured, and before the part is halved, it is
/// tried to prove that the geometries stay apart in all of it (settleMoving). Enclosing
/// shapes are measured at several way-points at once if these are many; between way-points, not for
/// links with one mesh each. Geometries of possible near misses are first measured where the shapes
/// are nearest, so that fewer are measured later. Far pairs, and pairs that were close before, are
/// settled over several segments.
///
/// Error: at the `time` of a contact the distance is within `tolerance` of contact_distance, and it
/// was not nearer before. `at_least` is a lower bound up to rounding.
/// Limits: a mesh inside another without touching surfaces is a contact if the other is closed.
/// Source: Schwarzer, Saha, Latombe (2005), section III, for the bound and the halving.
/// @param start poses of all links, with the path's joints at the first way-point. Links that the
/// path does not move keep these poses.
TrajectoryReport checkTrajectory(const CycleSetup& setup, const JointPath& path,
                                 const LinkPoses& start, const TrajectoryOptions& options);

/// The verdict of the whole path: a warning if a pair comes within `margin` [m]. Pairs that are
/// undecided are unknown, and so is a path without pairs.
Verdict verdictOf(const TrajectoryReport& report, const TrajectoryOptions& options) noexcept;

}  // namespace collision_monitor
