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

/// Settles one link pair in one part of the path.
namespace collision_monitor {

/// The level of a measurement.
enum class Level : unsigned char { balls, bodies, hulls, elements };

struct Sample {
  double bound{0.0};   ///< [m] lower bound of the distance
  double leeway{0.0};  ///< [m] lower bound of distance minus contact distance
  Level level{Level::balls};
  /// The level is `elements`, and the search stopped at its cutoff.
  bool is_bound{false};
  /// [m] At level `elements`: MeshDistance::outside, or `leeway` if that is larger.
  double outside{std::numeric_limits<double>::infinity()};
};

/// Poses and samples at one time.
struct Instant {
  std::size_t segment{0};
  double share{0.0};
  std::vector<Pose> world_from_link;     ///< by LinkId, of the links that are placed
  std::vector<Eigen::Vector3d> centers;  ///< by LinkId: centers of balls, world frame
  std::vector<Sample> samples;           ///< by LinkPairIndex, for pairs in the search
};

/// Scratch of one part that may be halved.
struct Halving {
  Instant middle;
  std::size_t depth{0};                              ///< how often a segment was halved
  bool is_placed{false};                             ///< links are placed in the middle
  const std::vector<LinkPairIndex>* pairs{nullptr};  ///< those that the part is searched for
  std::vector<LinkPairIndex> open;                   ///< those of them that are not settled
  std::vector<double> travels;                       ///< by path joint
  std::vector<JointStep> steps;                      ///< by path joint; known if links are placed
};

/// What `nearest` of a pair was measured between.
enum class Found : unsigned char { bodies, bounds, elements };

/// Where a pair is nearest, by its balls or by its bodies at way-points.
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
  JointLevers levers;                   ///< at the beginning of the part that is settled
  std::vector<LinkChain> chains;        ///< by LinkPairIndex
  std::vector<Found> found;             ///< by LinkPairIndex: level of `nearest`
  std::vector<NearPlace> by_balls;      ///< by LinkPairIndex
  std::vector<NearPlace> by_waypoints;  ///< by LinkPairIndex
  /// By LinkPairIndex: the level of the last settleMoving in a segment; balls if it failed.
  std::vector<Level> proven_by;
  std::vector<LinkPairIndex> moving;  ///< pairs that the path moves and that are not in contact
  std::deque<Halving> halvings;       ///< by depth; a deque keeps references valid
  std::deque<Halving> ranges;  ///< by depth, for parts of several segments; `middle` is unused
  std::vector<Instant> stops;  ///< the current way-points, from `first_stop` on
  std::size_t first_stop{0};
  TrajectoryReport report;
  bool is_ended{false};                        ///< options.progress ended the search
  std::optional<WaypointDistances> waypoints;  ///< if there are enough way-points
  std::vector<unsigned char> is_wanted{};      ///< scratch of place()
  std::uint64_t told_work{0};                  ///< work when progress was last reported
};

/// [m] Distances above this need not be known.
double wantedOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept;

/// Makes a sample of a distance of balls, bodies or hulls. If some depth is allowed, overlapping
/// ones give no bound: see contactOfBodies.
Sample sampleBy(const TrajectorySearch& search, LinkPairIndex pair, double distance,
                Level level) noexcept;

double timeOf(const TrajectorySearch& search, const Instant& at) noexcept;

/// Places all links at an instant.
/// @pre segment and share are set.
void place(TrajectorySearch& search, Instant& at);

/// Places only the links of some pairs, and those that carry them.
void place(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs, Instant& at);

/// Remembers where the balls of pairs are nearest.
void noteBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
               const Instant& at) noexcept;

/// Samples pairs by their balls.
void sampleBalls(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                 Instant& at) noexcept;

/// Measures the bodies of pairs at the way-points from this one on, if that pays off, and the
/// elements of possible near misses where their bodies are nearest.
/// @return the end of the measured way-points.
std::size_t lookAhead(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                      std::size_t waypoint);

/// Samples pairs at a way-point by their bodies, else by their balls.
/// @param at an end of a segment at this way-point. @pre lookAhead has measured it.
void sampleWaypoint(TrajectorySearch& search, const std::vector<LinkPairIndex>& pairs,
                    std::size_t waypoint, Instant& at) noexcept;

/// Whether the samples at both ends settle a pair in a part, before which it was apart. Measures
/// nothing.
/// @pre levers are at `begin`
bool settleFar(TrajectorySearch& search, LinkPairIndex pair, const Instant& begin,
               const Instant& end, const std::vector<double>& travels) noexcept;

/// [m] A pair whose elements stay farther apart than this in a part is settled.
double cutoffOf(const TrajectorySearch& search, LinkPairIndex pair) noexcept;

/// Settles a pair in a part, before which it was apart, if its elements provably stay apart.
/// @param level hulls: by hulls, then by meshes; elements: hulls would not do
/// @param steps of the part, by path joint, about its middle
bool settleMoving(TrajectorySearch& search, LinkPairIndex pair, Level level, const Instant& middle,
                  const std::vector<JointStep>& steps);

/// Settles pairs that the last proof settled, if they provably stay apart between the stops `first`
/// and `last`. Takes them out of `range.open`. The motion is seen about the stop `middle`.
void settleClose(TrajectorySearch& search, std::size_t first, std::size_t middle, std::size_t last,
                 Halving& range);

/// Places the links of pairs in the middle of a part of one segment, unless they are.
void placeMiddle(TrajectorySearch& search, const Instant& begin, const Instant& end,
                 Halving& halving);

/// Settles a pair in a part, before which it was apart, if possible. Raises the levels of the
/// samples at both ends as far as that helps. @return whether the pair is settled.
/// @pre levers are at `begin`
bool settle(TrajectorySearch& search, LinkPairIndex pair, Instant& begin, Instant& end,
            Halving& halving);

/// Reports progress; false if the search must end.
bool goesOn(TrajectorySearch& search, std::size_t segment, double share);

/// As goesOn, if there was much work since the last time: some milliseconds.
bool goesOnWorking(TrajectorySearch& search, const Instant& at);

/// As goesOnWorking when the path is searched: only then may the share 1 end the search.
bool goesOnAtEnd(TrajectorySearch& search);

/// Marks a pair as clear up to an instant and undecided from there on.
void giveUp(TrajectorySearch& search, LinkPairIndex pair, const Instant& at) noexcept;

/// Replaces the nearest measurement by a nearer one, or by one of a higher level.
void keepNearest(TrajectorySearch& search, LinkPairIndex pair, const PairDistance& distance,
                 const Instant& at, Found found) noexcept;

}  // namespace collision_monitor
