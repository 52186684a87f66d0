// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/box_rows.h"

namespace collision_monitor {

/// Finds pairs without knowledge of earlier calls. Cuts space into slabs across two axes, and
/// sweeps each column, where two slabs cross, along the third. The sweep axis is the one where
/// boxes are smallest relative to the spread of the scene. Slabs are numbered modulo their count,
/// so a body far away costs nothing. A body is in every column that it overlaps, and a pair is
/// found in the first column that both share.
///
/// Source: Tracy, Buss, Woods, "Efficient Large-Scale Sweep and Prune Methods with AABB Insertion
/// and Removal" (2009), section 4 (subdivision beside the sweep). Departs from it: sorts anew in
/// each call, by radix, and keeps no order.
class SlabSweep {
 public:
  explicit SlabSweep(std::size_t body_count);

  /// Every pair of boxes that meet, in no order.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// The number of rows tested in the last call: its cost.
  std::size_t work() const noexcept { return work_; }

 private:
  struct Slabs {
    std::size_t axis{1};
    double per_metre{0.0};
    std::int32_t mask{0};  ///< the number of slabs, a power of two, minus one
  };
  struct Layout {
    std::size_t sweep_axis{0};
    std::array<Slabs, 2> slabs;
  };
  /// The slabs that a body overlaps, across both axes.
  struct Reach {
    std::array<std::int32_t, 2> first;
    std::array<std::int32_t, 2> last;
  };

  static Layout layOut(const std::vector<SmallBox>& boxes) noexcept;
  std::size_t columnAt(std::int32_t slab, std::int32_t other_slab) const noexcept;
  template <class Visit>
  void forColumns(const Reach& reach, const Visit& visit) const noexcept;
  bool countRows(const std::vector<SmallBox>& boxes) noexcept;
  void widenSlabs() noexcept;
  void fillRows(const std::vector<SmallBox>& boxes) noexcept;
  void sweepColumn(std::size_t column, std::vector<PairKey>& found) noexcept;

  Layout layout_;
  BoxRows rows_;
  std::vector<std::uint64_t> order_;  ///< lower end on the sweep axis, then body
  std::vector<std::uint64_t> scratch_;
  std::vector<Reach> reaches_;         ///< by body
  std::vector<std::uint32_t> starts_;  ///< by column: its first row; one more at the end
  std::vector<std::uint32_t> ends_;    ///< by column: one past its last row
  std::vector<RowPair> hits_;
  std::size_t work_{0};
};

}  // namespace collision_monitor
