// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/triangle_sides.h"

#include <tuple>

namespace collision_monitor {
namespace {

using Corners = std::array<std::uint32_t, 3>;

template <class Visit>
void forSides(const std::vector<Corners>& triangles, const Visit& visit) {
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      visit(TriangleSide{std::min(from, to), std::max(from, to), i, from < to});
    }
  }
}

}  // namespace

std::vector<TriangleSide> sidesOf(const std::vector<Corners>& triangles, std::size_t vertex_count) {
  // A counting sort by smaller vertex, then a sort at each vertex, which has few sides.
  std::vector<std::uint32_t> ends(vertex_count + 1, 0);
  forSides(triangles, [&](const TriangleSide& side) { ++ends[side.low + 1]; });
  for (std::size_t i = 1; i < ends.size(); ++i) {
    ends[i] += ends[i - 1];
  }
  std::vector<TriangleSide> sides(ends.back());
  forSides(triangles, [&](const TriangleSide& side) { sides[ends[side.low]++] = side; });
  // Each place now stands at the end of its vertex, where the next vertex begins.
  auto first = sides.begin();
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const auto last = sides.begin() + ends[i];
    std::sort(first, last, [](const TriangleSide& a, const TriangleSide& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
    first = last;
  }
  return sides;
}

}  // namespace collision_monitor
