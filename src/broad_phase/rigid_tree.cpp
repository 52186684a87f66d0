// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/rigid_tree.h"

#include <algorithm>

#include "broad_phase/box_tests.h"

namespace collision_monitor {
namespace {

/// Infinite boxes become very large: their centers are numbers.
void setChild(const SmallBox& box, std::size_t child, TreeNode& node) noexcept {
  constexpr float kFar = 1e15F;  // [m] squares of it are numbers, too
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.min[axis][child] = std::max(box.min[axis], -kFar);
    node.max[axis][child] = std::min(box.max[axis], kFar);
  }
}

}  // namespace

RigidTree::RigidTree(const std::vector<Aabb>& boxes) {
  std::vector<SmallBox> children;
  children.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    children.push_back(smallBoxOf(box));
  }
  while (!children.empty()) {
    levels_.push_back(nodes_.size());
    std::vector<SmallBox> parents;
    for (std::size_t first = 0; first < children.size(); first += kTreeChildren) {
      TreeNode& node = nodes_.emplace_back();
      parents.push_back(children[first]);
      for (std::size_t child = 0; child < kTreeChildren; ++child) {
        const bool is_there = first + child < children.size();
        setChild(is_there ? children[first + child] : emptyBox(), child, node);
        parents.back() =
            is_there ? unionOf(parents.back(), children[first + child]) : parents.back();
      }
    }
    children = parents.size() > 1 ? std::move(parents) : std::vector<SmallBox>();
  }
}

FoundBodies RigidTree::findNear(const NearBox& box,
                                std::vector<std::uint32_t>& room) const noexcept {
  std::uint32_t* first = room.data();
  std::size_t count = levels_.empty() ? 0 : 1;
  *first = 0;  // the highest node
  for (std::size_t level = levels_.size(); level > 0; --level) {
    std::uint32_t* const found = first + count;
    count = findNearChildren(nodes_.data() + levels_[level - 1], {first, count}, box,
                             level == 1 ? NearTest::fine : NearTest::rough, found);
    first = found;
  }
  return {first, first + count};
}

void RigidTree::squaredDistances(const TreeNode& node, const Eigen::Vector3d& point,
                                 double (&squared)[kTreeChildren]) noexcept {
  for (std::size_t child = 0; child < kTreeChildren; ++child) {
    squared[child] = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = point[static_cast<Eigen::Index>(axis)];
      // By the order of arguments NaN stays NaN.
      const double outside =
          std::max(std::max(node.min[axis][child] - at, at - node.max[axis][child]), 0.0);
      squared[child] += outside * outside;
    }
  }
}

}  // namespace collision_monitor
