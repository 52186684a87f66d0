// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace collision_monitor {

/// Indices [first, last).
struct IndexRange {
  std::size_t first{0};
  std::size_t last{0};

  friend bool operator==(const IndexRange& one, const IndexRange& other) noexcept {
    return one.first == other.first && one.last == other.last;
  }
};

/// What a cycle places and bounds: everything but objects that rest, see findResting.
struct MovedParts {
  std::vector<IndexRange> links;
  std::vector<IndexRange> bodies;
  std::vector<IndexRange> elements;
};

/// Calls `use` with every index of the ranges.
template <class Use>
void forIndices(const std::vector<IndexRange>& ranges, const Use& use) {
  for (const IndexRange& range : ranges) {
    for (std::size_t i = range.first; i < range.last; ++i) {
      use(i);
    }
  }
}

}  // namespace collision_monitor
