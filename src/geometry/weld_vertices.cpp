// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/weld_vertices.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace collision_monitor {

std::vector<std::uint32_t> firstEquals(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::make_tuple(vertices[i].x(), vertices[i].y(), vertices[i].z());
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple_cat(key(a), std::make_tuple(a)) < std::tuple_cat(key(b), std::make_tuple(b));
  });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool equals_last = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = equals_last ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace collision_monitor
