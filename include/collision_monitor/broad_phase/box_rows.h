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
inline void setRow(std::size_t row, std::uint32_t body, const SmallBox& box,
                   BoxRows& rows) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.min[axis][row] = box.min[axis];
    rows.max[axis][row] = box.max[axis];
  }
  rows.bodies[row] = body;
}
void padRows(std::size_t first, BoxRows& rows) noexcept;

/// Two rows that meet, `row` before `other`.
struct RowPair {
  std::uint32_t row;
  std::uint32_t other;
};

struct PairedRows {
  std::size_t next{0};   ///< the first row whose partners were not looked for
  std::size_t count{0};  ///< pairs written
  std::size_t seen{0};   ///< rows looked at
};

/// Writes the pairs that meet of the rows from `row` on and before `last`, in order. Stops before a
/// row for which `hits` may have no room left. The instruction set is chosen at run time; all
/// give the same.
/// @pre padding begins at `last`; `hits` has room for last - row pairs.
PairedRows pairRows(const BoxRows& rows, std::size_t row, std::size_t last,
                    std::vector<RowPair>& hits) noexcept;

/// The same for rows sorted by the lower end on `axis`: a row is left at the first that begins
/// behind its upper end.
PairedRows sweepRows(const BoxRows& rows, std::size_t row, std::size_t last, std::size_t axis,
                     std::vector<RowPair>& hits) noexcept;

/// Of a table of pairs those that meet: every body has its row, and the pair of the rows a and b
/// has the id at a * last + b of `ids`, or is none where that is kNone. Writes ids in place of
/// rows.
/// @pre padding begins at `last`, also of `ids`; `found` has room for last - row ids and
/// kRowPadding more.
PairedRows pairRowsOfTable(const BoxRows& rows, std::size_t row, std::size_t last,
                           const std::uint32_t* ids, std::vector<std::uint32_t>& found) noexcept;

}  // namespace collision_monitor
