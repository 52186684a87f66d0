// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/methods/slab_sweep.h"

namespace collision_monitor {

/// Keeps the pairs of boxes inflated by a margin, and tests only these until a box leaves its
/// inflated box. The margin follows the motion since the list was made: wide enough to last, narrow
/// enough to keep few pairs. It is 0 where the list would not last two calls, so incoherent motion
/// means a new sweep in every call.
///
/// Source: Verlet, "Computer 'experiments' on classical fluids I" (1967).
/// docs/decisions/broad-phase.md derives the margin.
class NeighbourList {
 public:
  explicit NeighbourList(std::size_t body_count);

  /// Every pair of boxes that meet, sorted.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// Whether the last list was expected to last.
  bool isCoherent() const noexcept { return margin_ > 0.0F; }

  /// The number of rows tested when the list was made: how hard the scene is for a sweep.
  std::size_t work() const noexcept { return sweep_.work(); }

 private:
  bool lasts(const std::vector<SmallBox>& boxes) const noexcept;
  float marginFor(const std::vector<SmallBox>& boxes) const noexcept;
  void rebuild(const std::vector<SmallBox>& boxes) noexcept;

  SlabSweep sweep_;
  std::vector<SmallBox> grown_;
  std::vector<PairKey> near_;  ///< pairs of inflated boxes that meet, sorted
  std::vector<PairKey> scratch_;
  float margin_{0.0F};
  std::size_t calls_{0};  ///< since the list was made
};

}  // namespace collision_monitor
