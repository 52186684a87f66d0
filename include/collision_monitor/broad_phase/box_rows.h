// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// Boxes as rows, one array a coordinate, so that one vector instruction looks at many of them.
/// Behind each stretch of rows stand kRowPadding rows of NaN, which meet nothing.
struct BoxRows {
  std::array<std::vector<float>, 3> min;
  std::array<std::vector<float>, 3> max;
  std::vector<std::uint32_t> bodies;
};

/// As many as the widest vector has lanes.
constexpr std::size_t kRowPadding = 16;

void reserveRows(std::size_t count, BoxRows& rows);
void resizeRows(std::size_t count, BoxRows& rows) noexcept;
void setRow(std::size_t row, std::uint32_t body, const SmallBox& box, BoxRows& rows) noexcept;
void padRows(std::size_t first, BoxRows& rows) noexcept;

struct RowHits {
  std::size_t count{0};  ///< rows written
  std::size_t seen{0};   ///< rows looked at
};

/// Writes the rows behind `row` and before `last` that meet it, in order. The instruction set is
/// chosen at run time; all give the same.
/// @pre padding begins at `last`; `hits` has room for all of them.
RowHits findBehind(const BoxRows& rows, std::size_t row, std::size_t last,
                   std::uint32_t* hits) noexcept;

/// The same for rows sorted by the lower end on `axis`: stops at the first that begins behind the
/// row's upper end, or at padding.
RowHits findBehindSorted(const BoxRows& rows, std::size_t row, std::size_t axis,
                         std::uint32_t* hits) noexcept;

}  // namespace collision_monitor
