// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// A uniform grid without borders. The hash of a cell's coordinates, modulo the table's size, gives
/// its bin. A body is entered in every cell that its box overlaps, and moves to neighbouring cells
/// as it moves. A body in very many cells is kept aside and tested against all others. Each pair is
/// found in one cell only: that of the lower corner of the intersection of its boxes.
///
/// Source: Teschner, Heidelberger, Mueller, Pomeranets, Gross, "Optimized Spatial Hashing for
/// Collision Detection of Deformable Objects" (2003); Ericson, "Real-Time Collision Detection"
/// (2005), section 7.1.
class HashedBins {
 public:
  explicit HashedBins(std::size_t body_count);

  /// Every pair of boxes that meet, in no order.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

 private:
  /// Cells [first, last] along each axis.
  struct CellRange {
    std::array<std::int32_t, 3> first{};
    std::array<std::int32_t, 3> last{};
  };
  enum class Place : unsigned char { nowhere, cells, aside };
  struct Entry {
    std::uint64_t cell;
    std::uint32_t body;
    std::uint32_t next;
  };

  bool suitsCells(const std::vector<SmallBox>& boxes) noexcept;
  void clear() noexcept;
  void move(std::uint32_t body, const SmallBox& box) noexcept;
  void enter(std::uint32_t body, std::uint64_t cell) noexcept;
  void leave(std::uint32_t body, std::uint64_t cell) noexcept;
  void findInBin(std::uint32_t head, const std::vector<SmallBox>& boxes,
                 std::vector<PairKey>& found) const noexcept;
  void findAside(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) const noexcept;
  std::int32_t cellAt(float coordinate) const noexcept;
  CellRange cellsOf(const SmallBox& box) const noexcept;
  std::uint64_t sharedCell(const SmallBox& a, const SmallBox& b) const noexcept;
  std::uint32_t& headOf(std::uint64_t cell) noexcept;

  std::vector<std::uint32_t> heads_;  ///< by bin: its first entry
  std::vector<Entry> entries_;
  std::uint32_t free_;            ///< first unused entry
  std::vector<CellRange> cells_;  ///< by body
  std::vector<Place> places_;     ///< by body
  double cells_per_metre_{0.0};
};

}  // namespace collision_monitor
