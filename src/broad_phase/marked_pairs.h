// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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
  constexpr std::size_t kTogether = 16;  // few of many words are marked: skips them together
  pairs.clear();
  for (std::size_t first = 0; first < marks.size(); first += kTogether) {
    const std::size_t last = std::min(first + kTogether, marks.size());
    std::uint64_t any = 0;
    for (std::size_t word = first; word < last; ++word) {
      any |= marks[word];
    }
    for (std::size_t word = first; any != 0 && word < last; ++word) {
      for (std::uint64_t left = marks[word]; left != 0; left &= left - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctzll(left));
        pairs.push_back(idAt<PairId>(64 * word + bit));
      }
      marks[word] = 0;
    }
  }
}

}  // namespace collision_monitor
