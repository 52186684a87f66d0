// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/Distances.h>

#include <cstddef>
#include <vector>

#include "pipeline/answers/gradient_row.h"
#include "ros_edge/watch.h"

namespace collision_monitor {

/// The message that lists near pairs of links, filled anew each cycle. Most of it is names, and
/// pairs mostly keep their places: an entry that stays with its pair keeps its names.
class DistanceList {
 public:
  /// Pairs of links within their report_distance, those that passed contact on the way, and the
  /// closest of all. It stands until the next is asked for.
  /// @pre always of the same set-up
  const Distances& fill(const Watch& watch);

 private:
  /// Whose names an entry holds.
  struct Named {
    bool by_anyone{false};
    PairId pair{};
    bool is_refined{false};
  };

  void fillEntry(const CycleSetup& setup, const PairDistance& distance, const GradientRow& row);

  Distances message_;
  std::vector<Named> named_;  ///< by entry
  std::size_t size_{0};       ///< entries filled so far
};

}  // namespace collision_monitor
