// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/Distances.h>

#include <cstddef>
#include <vector>

#include "pipeline/answers/gradient_row.h"
#include "ros_edge/watch.h"

namespace collision_monitor {

/// The message that lists near link pairs, filled in each cycle. Names are most of it, and pairs
/// mostly keep their positions, so an entry that still has the same pair keeps its names.
class DistanceList {
 public:
  /// Link pairs within their report_distance, those that passed contact since the last cycle, and
  /// the closest of all. Valid until the next call.
  /// @pre all calls since the last forgetNames() are for one set-up
  const Distances& fill(const Watch& watch);
  /// For another set-up, whose pairs have other names.
  void forgetNames() { named_.clear(); }

 private:
  /// The pair whose names an entry holds.
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
