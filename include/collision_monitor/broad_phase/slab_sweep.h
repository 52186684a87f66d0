// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "collision_monitor/broad_phase/box_rows.h"
#include "collision_monitor/broad_phase/pair_keys.h"

namespace collision_monitor {

/// Cuts space into slabs across one axis and sweeps each along another, anew in every call: what
/// finds pairs when nothing is known of where bodies were. The axes are those along which
/// boxes are the smallest beside the spread of the scene. Slabs are numbered by modulus, so
/// that a body far away costs nothing; a body stands in every slab it reaches into, and a pair
/// is found in the first that both are in.
///
/// Source: Tracy, Buss, Woods, "Efficient Large-Scale Sweep and Prune Methods with AABB Insertion
/// and Removal" (2009), section 4 (subdivision beside the sweep). Departs from it in sorting
/// anew, by radix, instead of keeping order.
class SlabSweep {
 public:
  explicit SlabSweep(std::size_t body_count);

  /// Every pair of boxes that meet, in no order.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// Rows looked at in the last call: what it cost.
  std::size_t work() const noexcept { return work_; }

 private:
  struct Layout {
    std::size_t sweep_axis{0};
    std::size_t slab_axis{1};
    double slabs_per_metre{0.0};
    std::int32_t slab_mask{0};  ///< number of slabs, a power of two, less one
  };

  static Layout layOut(const std::vector<SmallBox>& boxes) noexcept;
  bool countRows(const std::vector<SmallBox>& boxes) noexcept;
  void fillRows(const std::vector<SmallBox>& boxes) noexcept;
  void sweepSlab(std::size_t slab, std::vector<PairKey>& found) noexcept;
  std::int32_t slabAt(float coordinate) const noexcept;
  std::int32_t lastSlabOf(const SmallBox& box, std::int32_t first) const noexcept;

  Layout layout_;
  BoxRows rows_;
  std::vector<std::uint64_t> order_;  ///< lower end on the sweep axis, then body
  std::vector<std::uint64_t> scratch_;
  std::vector<std::uint32_t> starts_;  ///< by slab: its first row; one more at the end
  std::vector<std::uint32_t> ends_;    ///< by slab: behind its last row
  std::vector<std::uint32_t> hits_;
  std::size_t work_{0};
};

}  // namespace collision_monitor
