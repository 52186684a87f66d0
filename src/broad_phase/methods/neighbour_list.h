// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/methods/slab_sweep.h"

namespace collision_monitor {

/// Keeps the pairs of boxes grown by a margin and looks at nothing else until a box leaves its
/// grown one. The margin follows the motion since the last such moment: wide enough to last, narrow
/// enough to keep few pairs, and none where it would not last two calls, so that in
/// disordered motion this is a sweep anew in every call.
///
/// Source: Verlet, "Computer 'experiments' on classical fluids I" (1967); the margin is worked out
/// in docs/decisions/broad-phase.md.
class NeighbourList {
 public:
  explicit NeighbourList(std::size_t body_count);

  /// Every pair of boxes that meet, sorted.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// Whether the list that was last made was expected to last.
  bool isCoherent() const noexcept { return margin_ > 0.0F; }

  /// Rows looked at when the list was last made: how hard the scene is for a sweep.
  std::size_t work() const noexcept { return sweep_.work(); }

 private:
  bool lasts(const std::vector<SmallBox>& boxes) const noexcept;
  float marginFor(const std::vector<SmallBox>& boxes) const noexcept;
  void rebuild(const std::vector<SmallBox>& boxes) noexcept;

  SlabSweep sweep_;
  std::vector<SmallBox> grown_;
  std::vector<PairKey> near_;  ///< pairs of grown boxes that meet, sorted
  std::vector<PairKey> scratch_;
  float margin_{0.0F};
  std::size_t calls_{0};  ///< since the list was made
};

}  // namespace collision_monitor
