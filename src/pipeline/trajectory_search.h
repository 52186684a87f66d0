// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "collision_monitor/pipeline/check_trajectory.h"
#include "collision_monitor/pipeline/motion_bound.h"
#include "pipeline/link_pair_distance.h"
#include "pipeline/path_poses.h"
#include "pipeline/waypoint_distances.h"

/// How checkTrajectory settles one pair in one part of the way.
namespace collision_monitor {

/// How a distance was measured.
enum class Level : unsigned char { balls, bodies, elements };

struct Sample {
  double bound{0.0};   ///< [m] the links are at least so far apart
  double leeway{0.0};  ///< [m] and so far from contact
  Level level{Level::balls};
  /// [m] How far the links may go until one can be inside the other; of elements.
  double outside{std::numeric_limits<double>::infinity()};
};

/// The links at one time.
struct Instant {
  std::size_t segment{0};
  double share{0.0};
  std::vector<Pose> world_from_link;
  std::vector<Sample> samples;  ///< by LinkPairIndex, of the pairs that are looked at
};

/// What one halving works with.
struct Halving {
  Instant middle;
  std::vector<LinkPairIndex> open;
  std::vector<double> ways;  ///< by path joint
};

/// Where a pair is nearest, as far as its balls or its bodies at the way-points tell.
struct NearPlace {
  double bound{std::numeric_limits<double>::infinity()};
  std::size_t segment{0};
  double share{0.0};
};

struct TrajectorySearch {
  const CycleSetup& setup;
  const JointPath& path;
  const TrajectoryOptions& options;
  PathPoses poses;
  LinkPairMeasures measures;
  std::vector<LinkChain> chains;        ///< by LinkPairIndex
  std::vector<unsigned char> is_final;  ///< by LinkPairIndex: `nearest` is of elements
  std::vector<NearPlace> by_balls;      ///< by LinkPairIndex
  std::vector<NearPlace> by_waypoints;  ///< by LinkPairIndex
  std::deque<Halving> halvings;         ///< by depth; a deque, for places in it stay
  TrajectoryReport report;
  bool is_ended{false};                        ///< by options.progress
  std::optional<WaypointDistances> waypoints;  ///< where there are enough of them to pay
};

/// Looks at the pairs by their balls.
void sampleBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                 Instant& at) noexcept;

/// Looks at the pairs at a way-point by their bodies, or else by their balls.
/// @param at begins or ends a segment there.
void sampleWaypoint(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                    std::size_t waypoint, Instant& at) noexcept;

/// Whether all is known of a pair in a part of the way, before which it was apart. Raises the
/// levels of the samples at both ends as far as that helps.
bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            const std::vector<double>& ways);

/// The pair is clear up to here, and no more is known.
void giveUp(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept;

/// Takes a distance for the nearest if it is that, or the first of elements.
void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, bool is_final) noexcept;

}  // namespace collision_monitor
