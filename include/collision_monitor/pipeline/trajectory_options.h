// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace collision_monitor {

/// How far a path is searched.
struct TrajectoryOptions {
  /// [m] Pairs nearer than this are near misses, and their nearest approach is searched for. Other
  /// pairs are only proven to stay farther apart. <= 0: only contacts are searched for, which is
  /// faster.
  double margin{0.05};
  std::vector<double> margins;  ///< [m] by LinkPairIndex, at most `margin`; empty: `margin` for all
  double resolution{1e-3};      ///< [m] how much nearer than reported a near miss may be
  double tolerance{1e-6};       ///< [m] contact is up to contact_distance + tolerance
  /// Work as in RefineLimits::budget; each placed link and each pair visited in a part count one.
  std::uint64_t budget{std::numeric_limits<std::uint64_t>::max()};
  /// Receives the growing share that is done, after each way-point and after some milliseconds of
  /// work, then perhaps the same again. Returns false to end the search. May be empty.
  std::function<bool(double done)> progress;
};

/// [m] The margin of a pair.
inline double marginOf(const TrajectoryOptions& options, std::size_t link_pair) noexcept {
  return options.margins.empty() ? options.margin : options.margins[link_pair];
}

/// What a search proved about two links on a path.
enum class ApproachState : unsigned char {
  clear,      ///< proven: no contact on the whole path
  contact,    ///< proven: first contact at `time`, clear before
  undecided,  ///< the budget or `progress` ended the search; clear up to `time`
  unknown,    ///< the links' relative pose is unknown, or the path is not sound
};

}  // namespace collision_monitor
