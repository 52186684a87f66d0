// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "pipeline/data/motion_bound.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "pipeline/trajectory/path_poses.h"
#include "pipeline/trajectory/waypoint_distances.h"

/// How checkTrajectory settles one pair in one part of the way.
namespace collision_monitor {

/// How a distance was measured.
enum class Level : unsigned char { balls, bodies, hulls, elements };

struct Sample {
  double bound{0.0};   ///< [m] the links are at least so far apart
  double leeway{0.0};  ///< [m] and so far from contact
  Level level{Level::balls};
  /// Of elements: no more was asked, or no more need be known.
  bool is_bound{false};
  /// [m] How far the links may go until one can be inside the other; of elements.
  double outside{std::numeric_limits<double>::infinity()};
};

/// The links at one time.
struct Instant {
  std::size_t segment{0};
  double share{0.0};
  std::vector<Pose> world_from_link;
  std::vector<Eigen::Vector3d> centers;  ///< of the balls, by LinkId, in the world
  std::vector<Sample> samples;           ///< by LinkPairIndex, of the pairs that are looked at
};

/// What one halving works with.
struct Halving {
  Instant middle;
  std::vector<LinkPairIndex> open;
  std::vector<double> travels;  ///< by path joint
};

/// What `nearest` of a pair was measured by.
enum class Found : unsigned char { bodies, bounds, elements };

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
  std::vector<Found> found;             ///< by LinkPairIndex: what `nearest` is of
  std::vector<NearPlace> by_balls;      ///< by LinkPairIndex
  std::vector<NearPlace> by_waypoints;  ///< by LinkPairIndex
  std::vector<LinkPairIndex> moving;    ///< that the path moves, without those that are in contact
  std::deque<Halving> halvings;         ///< by depth; a deque, for places in it stay
  std::deque<Halving> ranges;  ///< by depth: of parts of several segments, without `middle`
  std::vector<Instant> stops;  ///< the way-points at hand, from way-point `first_stop` on
  std::size_t first_stop{0};
  TrajectoryReport report;
  bool is_ended{false};                        ///< by options.progress
  std::optional<WaypointDistances> waypoints;  ///< where there are enough of them to pay
};

/// [m] What is farther apart need not be known.
double wantedOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept;

/// What balls, bodies or hulls say of elements. Where some depth is allowed, those that overlap say
/// nothing: see contactOfBodies.
Sample sampleBy(const TrajectorySearch& search, double distance, Level level) noexcept;

double timeOf(const TrajectorySearch& search, const Instant& at) noexcept;

/// Places the links.
/// @pre segment and share are set.
void place(TrajectorySearch& search, Instant& at);

/// Notes how near the balls of pairs are at a time.
void noteBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
               const Instant& at) noexcept;

/// Looks at the pairs by their balls.
void sampleBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                 Instant& at) noexcept;

/// Measures the bodies of pairs at the way-points from this one on, as far as that is of use, and
/// the elements of those that may be near misses where their bodies are nearest.
/// @return behind the last way-point that is measured.
std::size_t lookAhead(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                      std::size_t waypoint);

/// Looks at the pairs at a way-point by their bodies, or else by their balls.
/// @param at begins or ends a segment there. @pre lookAhead measured there.
void sampleWaypoint(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                    std::size_t waypoint, Instant& at) noexcept;

/// Whether the samples at both ends tell all of a pair in a part of the way, before which it was
/// apart. Measures nothing.
bool settleFar(TrajectorySearch& search, LinkPairIndex pair, const Instant& begin,
               const Instant& end, const std::vector<double>& travels) noexcept;

/// Whether all is known of a pair in a part of the way, before which it was apart. Raises the
/// levels of the samples at both ends as far as that helps.
bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            const std::vector<double>& travels);

/// The pair is clear up to here, and no more is known.
void giveUp(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept;

/// Takes a distance for the nearest if it is that, or tells more.
void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, Found found) noexcept;

}  // namespace collision_monitor
