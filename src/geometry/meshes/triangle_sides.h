// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// A side of a triangle, smaller vertex first.
struct TriangleSide {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  bool is_forward;  ///< the triangle runs from low to high

  bool hasEdgeOf(const TriangleSide& other) const { return low == other.low && high == other.high; }
};

/// The sides of all triangles, sorted by edge and then by triangle. Triangles with two equal
/// corners have none.
/// @pre all corners are below `vertex_count`.
std::vector<TriangleSide> sidesOf(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  std::size_t vertex_count);

/// Calls visit(first, last) for the sides along each edge.
template <class Visit>
void forEdges(const std::vector<TriangleSide>& sides, const Visit& visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if_not(
        first, sides.end(), [&](const TriangleSide& side) { return side.hasEdgeOf(*first); });
    visit(first, last);
    first = last;
  }
}

}  // namespace collision_monitor
