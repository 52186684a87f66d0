// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// Sweep and prune on three axes. The end points of each axis stay sorted between calls. Insertion
/// sort restores the order in nearly linear time while motion is coherent. A lower end that passes
/// an upper end may add a pair; an upper end that passes a lower end may remove one. Such pairs are
/// then confirmed on all axes. When too many ends pass each other, the axes are sorted anew, and
/// the axis with the fewest overlapping intervals is swept with a list of active intervals.
///
/// Source: Cohen, Lin, Manocha, Ponamgi, "I-COLLIDE: an interactive and exact collision
/// detection system for large-scale environments" (1995), section 4; Tracy, Buss, Woods (2009).
/// Departs from them: keeps sorted lists of pairs, not flags for each pair and axis.
class SweepAndPrune {
 public:
  explicit SweepAndPrune(std::size_t body_count);

  /// Every pair of boxes that meet, sorted.
  /// @pre as many boxes as given to the constructor.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// Whether the last call had to sort the axes anew because motion was not coherent.
  bool isAnew() const noexcept { return is_anew_; }

 private:
  /// From the highest bit down: position on the axis, whether it is an upper end, the body. At one
  /// position, intervals open before others close, so touching ones overlap.
  using EndPoint = std::uint64_t;
  using EndPoints = std::vector<EndPoint>;

  void moveEndPoints(const std::vector<SmallBox>& boxes) noexcept;
  bool sortByInsertion(const std::vector<SmallBox>& boxes) noexcept;
  void pass(EndPoint moved, EndPoint passed, const std::vector<SmallBox>& boxes) noexcept;
  void updatePairs(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;
  void startAnew(const std::vector<SmallBox>& boxes) noexcept;
  std::size_t leastCrowdedAxis(const std::vector<SmallBox>& boxes) const noexcept;
  void open(std::uint32_t body, const std::vector<SmallBox>& boxes) noexcept;
  void close(std::uint32_t body) noexcept;

  std::array<EndPoints, 3> axes_;
  std::vector<PairKey> pairs_;  ///< that met in the last call, sorted
  std::vector<PairKey> added_;
  std::vector<std::uint64_t> scratch_;
  std::vector<std::uint32_t> active_;          ///< bodies whose interval is open
  std::vector<std::uint32_t> slot_in_active_;  ///< by body
  bool have_parted_{false};
  bool is_sorted_{false};
  bool is_anew_{false};
};

}  // namespace collision_monitor
