// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/vertex_blocks.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSmall = 8;       // greatest size of a block without children
constexpr double kSumRounding = 1e-14;  // several times that of a product or sum of three

}  // namespace

VertexBlocks::VertexBlocks(const std::vector<Vector3d>& vertices)
    : vertices_(vertices), order_(vertices.size()) {
  double size = 0.0;
  for (const Vector3d& vertex : vertices_) {
    size = std::max(size, vertex.norm());
  }
  rounding_ = kSumRounding * size;
  std::iota(order_.begin(), order_.end(), 0U);
  add(0, order_.size());
}

void VertexBlocks::add(std::size_t first, std::size_t last) {
  Vector3d low = vertices_[order_[first]];
  Vector3d high = low;
  for (std::size_t i = first; i < last; ++i) {
    low = low.cwiseMin(vertices_[order_[i]]);
    high = high.cwiseMax(vertices_[order_[i]]);
  }
  const Vector3d center = 0.5 * low + 0.5 * high;
  double radius = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    radius = std::max(radius, (vertices_[order_[i]] - center).norm());
  }
  const std::size_t own = blocks_.size();
  blocks_.push_back({center, radius + rounding_, first, last, 0});
  if (last - first > kSmall) {
    const std::size_t middle = halve(first, last, high - low);
    add(first, middle);
    add(middle, last);
  }
  blocks_[own].next = blocks_.size();
}

std::size_t VertexBlocks::halve(std::size_t first, std::size_t last, const Vector3d& size) {
  Eigen::Index axis = 0;
  size.maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return vertices_[a][axis] < vertices_[b][axis];
  });
  return middle;
}

std::uint32_t VertexBlocks::farthest(const Vector3d& direction,
                                     std::uint32_t likely) const noexcept {
  const double length = direction.norm();
  std::uint32_t best = likely;
  double reach = direction.dot(vertices_[likely]);
  for (std::size_t at = 0; at < blocks_.size();) {
    const Block& block = blocks_[at];
    if (direction.dot(block.center) + length * block.radius < reach) {
      at = block.next;
      continue;
    }
    ++at;
    if (block.last - block.first > kSmall) {
      continue;
    }
    for (std::size_t i = block.first; i < block.last; ++i) {
      const std::uint32_t vertex = order_[i];
      const double own = direction.dot(vertices_[vertex]);
      if (own > reach || (own == reach && vertex < best)) {
        reach = own;
        best = vertex;
      }
    }
  }
  return best;
}

}  // namespace collision_monitor
