// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/rigid_tree.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

/// The axis along which the centers of these boxes spread most.
std::size_t widestAxis(const std::vector<SmallBox>& boxes, const std::uint32_t* first,
                       const std::uint32_t* last) {
  std::size_t widest = 0;
  double width = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(first, last, [&](std::uint32_t one, std::uint32_t other) {
          return centerOf(boxes[one], axis) < centerOf(boxes[other], axis);
        });
    const double spread = centerOf(boxes[*high], axis) - centerOf(boxes[*low], axis);
    if (spread > width) {
      width = spread;
      widest = axis;
    }
  }
  return widest;
}

}  // namespace

RigidTree::RigidTree(const std::vector<Aabb>& boxes) {
  std::vector<SmallBox> small;
  small.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    small.push_back(smallBoxOf(box));
  }
  std::vector<std::uint32_t> bodies(boxes.size());
  std::iota(bodies.begin(), bodies.end(), 0U);
  nodes_.reserve(2 * boxes.size());
  if (!bodies.empty()) {
    build(small, bodies.data(), bodies.data() + bodies.size());
  }
}

/// Adds the subtree of these bodies, in halves of equal count. They are not none.
void RigidTree::build(const std::vector<SmallBox>& boxes, std::uint32_t* first,
                      std::uint32_t* last) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back().box = boxes[*first];
  for (const std::uint32_t* body = first + 1; body != last; ++body) {
    nodes_[node].box = unionOf(nodes_[node].box, boxes[*body]);
  }
  if (last - first == 1) {
    nodes_[node].body = *first;
  } else {
    const std::size_t axis = widestAxis(boxes, first, last);
    std::uint32_t* const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](std::uint32_t one, std::uint32_t other) {
      return centerOf(boxes[one], axis) < centerOf(boxes[other], axis);
    });
    build(boxes, first, middle);
    build(boxes, middle, last);
  }
  nodes_[node].next = static_cast<std::uint32_t>(nodes_.size());
}

double RigidTree::squaredDistance(const SmallBox& box, const Eigen::Vector3d& point) noexcept {
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = point[static_cast<Eigen::Index>(axis)];
    const double outside = std::max({box.min[axis] - at, at - box.max[axis], 0.0});
    squared += outside * outside;
  }
  return squared;
}

}  // namespace collision_monitor
