// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// Pairs of a table as one bit each. Reading the marks from first to last sorts the pairs. A bit a
/// word tells where marks are: of a million pairs with objects few are marked.
struct MarkedPairs {
  std::vector<std::uint64_t> words;     ///< bit i % 64 of word i / 64: pair i
  std::vector<std::uint64_t> has_mark;  ///< likewise of words

  /// No pair is marked.
  explicit MarkedPairs(std::size_t pair_count = 0)
      : words(pair_count / 64 + 1, 0), has_mark(words.size() / 64 + 1, 0) {}
};

inline void markPair(std::size_t pair, MarkedPairs& marks) noexcept {
  const std::size_t word = pair / 64;
  marks.words[word] |= std::uint64_t{1} << (pair % 64);
  marks.has_mark[word / 64] |= std::uint64_t{1} << (word % 64);
}

/// Calls `take` with the index of each set bit, and clears them.
template <class Take>
void takeBits(std::uint64_t& bits, std::size_t first, const Take& take) noexcept {
  for (; bits != 0; bits &= bits - 1) {
    take(first + static_cast<std::size_t>(__builtin_ctzll(bits)));
  }
}

/// Fills the list with the marked pairs, and clears the marks.
inline void takeMarked(MarkedPairs& marks, std::vector<PairId>& pairs) noexcept {
  pairs.clear();
  for (std::size_t i = 0; i < marks.has_mark.size(); ++i) {
    takeBits(marks.has_mark[i], 64 * i, [&](std::size_t word) {
      takeBits(marks.words[word], 64 * word,
               [&](std::size_t pair) { pairs.push_back(idAt<PairId>(pair)); });
    });
  }
}

}  // namespace collision_monitor
