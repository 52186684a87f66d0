// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/pipeline/element.h"

namespace collision_monitor {

/// What pairs ask of a speed scale.
struct SpeedDemand {
  double scale{1.0};
  bool is_free{true};  ///< nothing closes, nothing near rests, and nothing is unknown
};

/// The least that pairs say, at most.
struct LeastOfPairs {
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]
  double warned{std::numeric_limits<double>::infinity()};    ///< [m] of pairs that are warnings
  double time{std::numeric_limits<double>::infinity()};      ///< [s] to contact
  double scale{1.0};                                         ///< of the speed
};

/// How far ahead pairs of a robot are looked at.
struct Watched {
  double time{0.0};        ///< [s] pairs that may touch within it matter
  double of_settled{0.0};  ///< [s] as `time`, for pairs that are a warning anyway
  double distance{0.0};    ///< [m] pairs up to this distance matter even if nothing moves
  double warned{0.0};      ///< [m] as `distance`, for pairs that are a warning
};

/// As it is from the start.
inline bool expectsNothing(const LeastOfPairs& expected) noexcept {
  return std::isinf(expected.distance);
}

/// Bits of RobotSpeeds::has_unknown.
constexpr unsigned char kHasUnknown = 1;
constexpr unsigned char kHasLost = 2;  ///< of these, pairs that were in contact or a warning before

/// The speed scale of each robot. By RobotId, without the robots that objects form; one more stands
/// for what no robot moves, as a table.
struct RobotSpeeds {
  std::vector<double> scales;  ///< 0 stop .. 1 full speed, of the pairs of links that it moves
  /// The robot's unknown pairs ask nothing of other robots, but for those that were in contact or a
  /// warning before. Set before a cycle.
  std::vector<unsigned char> is_excused;
  std::vector<std::uint32_t> robot_of_link;  ///< by LinkId: findMovers
  std::vector<SpeedDemand> demands;          ///< scratch
  std::vector<LeastOfPairs> least;           ///< what measureTold found
  /// Upper bounds that are expected of `least`. Pairs that cannot be below them are passed over.
  /// Without expectations all pairs are looked at, as where somebody listens to all distances.
  std::vector<LeastOfPairs> expected;
  std::vector<Watched> watched;  ///< what follows from `expected`
  /// The scale may jump to 1, but pairs were passed over: the next cycle seeks what closes.
  std::vector<unsigned char> may_be_free;
  bool passes_lone{false};  ///< lone bodies are passed over by how they close
  /// A scale may jump to 1: nothing is passed over that may close or rest.
  bool seeks_closing{false};
  /// The elements that closed fastest when closing ones were last sought. kNone: none closed, or
  /// all scales are 1. These elements are not passed over: while they close, no scale jumps, and no
  /// others need be sought.
  ElementPairIndex closing{kNone};
  /// By robot * number of scales + robot: kHasUnknown, kHasLost, of pairs between them.
  std::vector<unsigned char> has_unknown;
  std::uint64_t noted{0};  ///< PairEvents::complete_judgements that `has_unknown` follows
};

/// All scales are 1, and no robot is excused.
RobotSpeeds makeRobotSpeeds(const RobotModel& model);

}  // namespace collision_monitor
