// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "collision_monitor/pipeline/trajectory_options.h"
#include "collision_monitor/pipeline/verdict.h"
#include "collision_monitor/robot_monitor.h"

namespace collision_monitor {

struct QueryParts;

/// The distance of two links. Frames: world. Sign: as SignedDistance.
struct MeasuredPair {
  std::uint32_t pair{0};              ///< index into RobotMonitor::pairs()
  std::uint32_t shape_a{0};           ///< index into RobotMonitor::shapes(): the nearest ones
  std::uint32_t shape_b{0};           ///< likewise, of the second link
  Quality quality{Quality::unknown};  ///< of the distance
  Verdict verdict{Verdict::unknown};  ///< by contact_distance and warning_distance
  bool is_refined{false};             ///< measured between what the shapes enclose
  SignedDistance measured;            ///< unknown: all NaN
};

/// What is asked of distances.
struct DistanceRequest {
  double within{std::numeric_limits<double>::infinity()};  ///< [m] farther pairs are left out
  bool gradients{false};                                   ///< fill DistanceTable::gradients
};

/// The answer of RobotQuery::distances.
struct DistanceTable {
  /// In the order of RobotMonitor::pairs(). Pairs of unknown distance are never left out.
  std::vector<MeasuredPair> pairs;
  /// [m/rad] or [m/m] One row of n numbers for each of `pairs`: the derivative of its distance by
  /// the velocity of each variable (a floating joint: as jointTwist). NaN where the distance is.
  std::vector<double> gradients;
};

/// Two links in contact.
struct TouchingPair {
  MeasuredPair between;                   ///< the two links, and where they are nearest
  std::uint32_t point_count{0};           ///< 0 if the pair is unknown
  std::array<Eigen::Vector3d, 4> points;  ///< world frame, midway between the two surfaces
};

/// The answer for one of many states.
struct StateAnswer {
  Verdict verdict{Verdict::unknown};  ///< StateQuestion::contact: contact, clear or unknown
  Quality quality{Quality::unknown};  ///< of the distance
  std::uint32_t pair{kNone};          ///< into RobotMonitor::pairs(); kNone if there is none
  /// [m] of `pair`, as checkStatesExactly: overlaps are not measured. NaN without a pair.
  double distance{std::numeric_limits<double>::quiet_NaN()};
};

/// What is asked of many states.
struct StatesRequest {
  StateQuestion question{StateQuestion::nearest};  ///< how much is looked for
  unsigned threads{0};                             ///< at most; 0: one for each processor
  /// Receives the growing share that is done, on the calling thread. Returns false to give up. May
  /// be empty.
  std::function<bool(double done)> progress;
};

/// Way-points, row by row: m states of n numbers.
struct WayPoints {
  Numbers positions;     ///< m x n, [rad] or [m]
  Numbers times{};       ///< [s] m, increasing; empty: 0, 1, 2, ...
  Numbers velocities{};  ///< empty, or like `positions`: joints move on cubics
};

/// The approach of two links on a path.
struct PairOnPath {
  ApproachState state{ApproachState::unknown};  ///< what was proven
  double time{0.0};      ///< [s] of `nearest`; undecided: until when the pair is clear
  double at_least{0.0};  ///< [m] proven lower bound of the distance, until the contact if any
  MeasuredPair nearest;  ///< the nearest measurement; in contact, the first contact
};

/// The answer of RobotQuery::checkPath.
struct PathAnswer {
  std::vector<PairOnPath> pairs;       ///< as RobotMonitor::pairs()
  std::uint32_t first_contact{kNone};  ///< the pair of the first contact, or kNone
  Verdict verdict{Verdict::unknown};   ///< warning: a pair comes within `margin`
};

/// Answers for joint values. It keeps scratch and warm starts: each thread needs its own.
///
/// A state has n numbers, in the order of RobotMonitor::variables(); limits of joints play no part.
/// A number that is NaN, infinite or beyond kFarthest is data, not an error: what depends on it is
/// unknown, never clear.
/// Answers by reference are valid until the next call. After the first call of its kind, a call
/// that returns a reference does not allocate.
/// Error: as docs/accuracy.md; earlier calls may change the last digits, depths of overlapping
/// meshes (Quality::estimate) by more, and which of equally near points are found.
/// @throws ArgumentError if a number of values is wrong, or a request holds NaN
class RobotQuery {
 public:
  /// Sizes scratch for the monitor's pairs. The query shares what is inside the monitor.
  explicit RobotQuery(const RobotMonitor& monitor);
  ~RobotQuery();
  RobotQuery(RobotQuery&& other) noexcept;  ///< the other one can only be assigned to or destroyed
  RobotQuery& operator=(RobotQuery&& other) noexcept;  ///< as the constructor

  const RobotMonitor& monitor() const noexcept;  ///< as given to the constructor

  /// The worst verdict of all pairs; unknown if a number of the state is not finite, even where
  /// other pairs are known to be in contact.
  Verdict verdict(Numbers state);
  /// The signed distance of every pair within a distance.
  const DistanceTable& distances(Numbers state, const DistanceRequest& request = {});
  /// The nearest of the pairs that are known; an unknown pair if there is none. `pair` is kNone if
  /// no pair is checked.
  const MeasuredPair& nearest(Numbers state);
  /// Pairs in contact, and those that are unknown.
  const std::vector<TouchingPair>& contacts(Numbers state);
  /// Poses of all links, by LinkId; not finite where they are unknown.
  const std::vector<Pose>& linkPoses(Numbers state);

  /// Many states, row by row. Each answer is the same for any number of threads and of states.
  /// @return by state; empty if progress gave up
  std::vector<StateAnswer> check(Numbers states, const StatesRequest& request = {});
  /// Proves for the whole path whether links touch, as checkTrajectory. Planar and floating joints
  /// must stay where they are.
  PathAnswer checkPath(const WayPoints& path, const TrajectoryOptions& options = {});

 private:
  std::unique_ptr<QueryParts> parts_;
};

}  // namespace collision_monitor
