// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/ids.h"

/// Pairs of a table as one bit each. Reading the marks from first to last sorts the pairs.
namespace collision_monitor {

inline void markPair(PairId pair, std::vector<std::uint64_t>& marks) noexcept {
  marks[index(pair) / 64] |= std::uint64_t{1} << (index(pair) % 64);
}

/// Fills the list with the marked pairs, and clears the marks.
inline void takeMarked(std::vector<std::uint64_t>& marks, std::vector<PairId>& pairs) noexcept {
  pairs.clear();
  for (std::size_t word = 0; word < marks.size(); ++word) {
    for (std::uint64_t left = marks[word]; left != 0; left &= left - 1) {
      const auto bit = static_cast<std::size_t>(__builtin_ctzll(left));
      pairs.push_back(idAt<PairId>(64 * word + bit));
    }
    marks[word] = 0;
  }
}

}  // namespace collision_monitor
