// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/marked_pairs.h"
#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/box_rows.h"
#include "collision_monitor/broad_phase/pair_table.h"

namespace collision_monitor {

/// Tests every pair, many at a time. Best for a robot, where most bodies are near each other
/// anyway. Keeps nothing between calls.
class BruteForce {
 public:
  explicit BruteForce(std::size_t body_count);

  /// Every pair of boxes that meet, sorted.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// Marks the pairs of a table that meet.
  /// @pre table.idsOfAll() is not null; `marks` has room for every pair.
  void markPairs(const std::vector<SmallBox>& boxes, const PairTable& table,
                 MarkedPairs& marks) noexcept;

 private:
  BoxRows rows_;
  std::vector<RowPair> hits_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace collision_monitor
