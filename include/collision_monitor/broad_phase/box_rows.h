// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// Boxes stored as one array per coordinate, so that one vector instruction tests many of them.
/// kRowPadding rows of NaN follow each stretch of rows. They meet nothing.
struct BoxRows {
  std::array<std::vector<float>, 3> min;  ///< by axis, then by row: lower ends [m]
  std::array<std::vector<float>, 3> max;  ///< by axis, then by row: upper ends [m]
  std::vector<std::uint32_t> bodies;      ///< by row: the body that the box bounds
};

/// The number of lanes of the widest vector.
constexpr std::size_t kRowPadding = 16;

/// Takes memory for `count` rows. @throws std::bad_alloc.
void reserveRows(std::size_t count, BoxRows& rows);
/// Changes the number of rows, the padding included. @pre reserveRows was called for `count`.
void resizeRows(std::size_t count, BoxRows& rows) noexcept;
/// Writes the box of one body. @pre the row exists.
inline void setRow(std::size_t row, std::uint32_t body, const SmallBox& box,
                   BoxRows& rows) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.min[axis][row] = box.min[axis];
    rows.max[axis][row] = box.max[axis];
  }
  rows.bodies[row] = body;
}
/// Writes the padding: kRowPadding rows of NaN from `first` on. @pre these rows exist.
void padRows(std::size_t first, BoxRows& rows) noexcept;

/// Two rows that meet, `row` before `other`.
struct RowPair {
  std::uint32_t row;    ///< the row that was being looked at
  std::uint32_t other;  ///< its partner
};

/// How far a search for pairs has come.
struct PairedRows {
  std::size_t next{0};   ///< the first row whose partners were not looked for
  std::size_t count{0};  ///< pairs written
  std::size_t seen{0};   ///< rows tested
};

/// Writes the pairs that meet among the rows [row, last), in order. Stops before a row for which
/// `hits` may lack room. The instruction set is chosen at run time; the result does not depend on
/// it.
/// @pre padding begins at `last`; `hits` has room for last - row pairs.
PairedRows pairRows(const BoxRows& rows, std::size_t row, std::size_t last,
                    std::vector<RowPair>& hits) noexcept;

/// As pairRows, for rows sorted by their lower end on `axis`. The search for a row's partners ends
/// at the first row that begins behind the row's upper end.
PairedRows sweepRows(const BoxRows& rows, std::size_t row, std::size_t last, std::size_t axis,
                     std::vector<RowPair>& hits) noexcept;

/// Writes the ids of those pairs of a table that meet. Every body has its own row. The pair of the
/// rows a and b has the id ids[a * last + b]; kNone means there is no such pair.
/// @pre padding begins at `last`, also in `ids`; `found` has room for last - row + kRowPadding ids.
PairedRows pairRowsOfTable(const BoxRows& rows, std::size_t row, std::size_t last,
                           const std::uint32_t* ids, std::vector<std::uint32_t>& found) noexcept;

}  // namespace collision_monitor
