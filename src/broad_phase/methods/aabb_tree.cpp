// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/aabb_tree.h"

#include <algorithm>

#include "broad_phase/box_tests.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

/// A tree is rebuilt when the area of its inner boxes has grown by kWornArea since it was built, or
/// when one in kManyChanges bodies appeared or vanished in one call.
constexpr double kWornArea = 1.5;
constexpr std::size_t kManyChanges = 8;

/// Half the surface area. Units: square metres. Infinite boxes are cut off far out.
double areaOf(const SmallBox& box) noexcept {
  constexpr double kFar = 1e18;
  double width[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    width[axis] = std::min<double>(box.max[axis], kFar) - std::max<double>(box.min[axis], -kFar);
  }
  return width[0] * width[1] + width[1] * width[2] + width[2] * width[0];
}

}  // namespace

AabbTree::AabbTree(std::size_t body_count) : in_tree_(body_count, 0) {
  const std::size_t nodes = 2 * body_count;
  nodes_.resize(nodes);
  for (std::size_t node = nodes; node-- > body_count;) {
    free_.push_back(static_cast<std::uint32_t>(node));
  }
  leaves_.reserve(body_count);
  order_.reserve(nodes);
  spans_.reserve(nodes);
  stack_.reserve(2 * nodes);
}

void AabbTree::findMeetings(const std::vector<SmallBox>& boxes,
                            std::vector<PairKey>& found) noexcept {
  update(boxes);
  found.clear();
  stack_.clear();
  if (root_ != kNone) {
    stack_.push_back({root_, root_});
  }
  while (!stack_.empty()) {
    const auto [one, other] = stack_.back();
    stack_.pop_back();
    if (one == other) {
      if (!isLeaf(one)) {
        const auto [left, right] = nodes_[one].children;
        stack_.push_back({left, left});
        stack_.push_back({right, right});
        stack_.push_back({left, right});
      }
    } else if (meets(nodes_[one].box, nodes_[other].box)) {
      if (isLeaf(one) && isLeaf(other)) {
        found.push_back(pairKey(one, other));
        continue;
      }
      const bool opens_one =
          isLeaf(other) || (!isLeaf(one) && areaOf(nodes_[one].box) > areaOf(nodes_[other].box));
      const auto [left, right] = nodes_[opens_one ? one : other].children;
      stack_.push_back({left, opens_one ? other : one});
      stack_.push_back({right, opens_one ? other : one});
    }
  }
}

/// Takes the boxes of this call, inserts bodies that became known, removes those that became
/// unknown, and rebuilds the tree where that is better.
void AabbTree::update(const std::vector<SmallBox>& boxes) noexcept {
  std::size_t changes = 0;
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    nodes_[body].box = boxes[body];
    changes += isEmpty(boxes[body]) == (in_tree_[body] != 0) ? 1U : 0U;
  }
  if (changes > boxes.size() / kManyChanges) {
    build(boxes);
    return;
  }
  for (std::uint32_t body = 0; changes != 0 && body < boxes.size(); ++body) {
    if (isEmpty(boxes[body]) && in_tree_[body] != 0) {
      remove(body);
    }
  }
  const double area = refit();
  for (std::uint32_t body = 0; changes != 0 && body < boxes.size(); ++body) {
    if (!isEmpty(boxes[body]) && in_tree_[body] == 0) {
      insert(body);
    }
  }
  if (area > kWornArea * built_area_) {
    build(boxes);
  }
}

void AabbTree::attach(std::uint32_t node, std::uint32_t parent, std::size_t side) noexcept {
  nodes_[node].parent = parent;
  if (parent == kNone) {
    root_ = node;
  } else {
    nodes_[parent].children[side] = node;
  }
}

std::size_t AabbTree::sideOf(std::uint32_t node) const noexcept {
  return nodes_[node].parent != kNone && nodes_[nodes_[node].parent].children[1] == node ? 1 : 0;
}

/// Builds the tree top-down, in halves of equal count along the axis where centers spread most.
void AabbTree::build(const std::vector<SmallBox>& boxes) noexcept {
  leaves_.clear();
  free_.clear();
  for (std::size_t body = boxes.size(); body-- > 0;) {
    const auto node = static_cast<std::uint32_t>(body);
    in_tree_[body] = isEmpty(boxes[body]) ? 0 : 1;
    if (in_tree_[body] != 0) {
      leaves_.push_back(node);
    }
    free_.push_back(node + static_cast<std::uint32_t>(boxes.size()));
  }
  root_ = kNone;
  spans_.clear();
  if (!leaves_.empty()) {
    spans_.push_back({0, leaves_.size(), kNone, 0});
  }
  while (!spans_.empty()) {
    const Span span = spans_.back();
    spans_.pop_back();
    if (span.last - span.first == 1) {
      attach(leaves_[span.first], span.parent, span.side);
      continue;
    }
    const std::uint32_t node = free_.back();
    free_.pop_back();
    attach(node, span.parent, span.side);
    const std::size_t middle = splitSpan(span);
    spans_.push_back({middle, span.last, node, 1});
    spans_.push_back({span.first, middle, node, 0});
  }
  built_area_ = refit();
}

std::size_t AabbTree::splitSpan(const Span& span) noexcept {
  const auto first = leaves_.begin() + static_cast<std::ptrdiff_t>(span.first);
  const auto last = leaves_.begin() + static_cast<std::ptrdiff_t>(span.last);
  std::size_t widest = 0;
  double width = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = centerOf(nodes_[*first].box, axis);
    double high = low;
    for (auto leaf = first; leaf != last; ++leaf) {
      low = std::min(low, centerOf(nodes_[*leaf].box, axis));
      high = std::max(high, centerOf(nodes_[*leaf].box, axis));
    }
    if (high - low > width) {
      width = high - low;
      widest = axis;
    }
  }
  const std::size_t middle = (span.first + span.last) / 2;
  std::nth_element(first, leaves_.begin() + static_cast<std::ptrdiff_t>(middle), last,
                   [&](std::uint32_t one, std::uint32_t other) {
                     return centerOf(nodes_[one].box, widest) < centerOf(nodes_[other].box, widest);
                   });
  return middle;
}

/// Recomputes the boxes of all inner nodes, children before parents, and rotates on the way.
/// @return their total surface area. Units: square metres.
double AabbTree::refit() noexcept {
  order_.clear();
  if (root_ != kNone && !isLeaf(root_)) {
    order_.push_back(root_);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) {
    for (const std::uint32_t child : nodes_[order_[i]].children) {
      if (!isLeaf(child)) {
        order_.push_back(child);
      }
    }
  }
  double area = 0.0;
  for (std::size_t i = order_.size(); i-- > 0;) {
    const std::uint32_t node = order_[i];
    const auto [left, right] = nodes_[node].children;
    nodes_[node].box = unionOf(nodes_[left].box, nodes_[right].box);
    rotate(node);
    area += areaOf(nodes_[node].box);
  }
  return area;
}

/// Swaps a child with a child of the other one if that makes the other one smaller. Takes the best
/// of four swaps.
void AabbTree::rotate(std::uint32_t node) noexcept {
  double best_gain = 0.0;
  std::size_t best_side = 0;
  std::size_t best_low_side = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::uint32_t high = nodes_[node].children[side];
    const std::uint32_t sibling = nodes_[node].children[1 - side];
    if (isLeaf(sibling)) {
      continue;
    }
    const double area = areaOf(nodes_[sibling].box);
    for (std::size_t low_side = 0; low_side < 2; ++low_side) {
      const std::uint32_t stays = nodes_[sibling].children[1 - low_side];
      const double gain = area - areaOf(unionOf(nodes_[high].box, nodes_[stays].box));
      if (gain > best_gain) {
        best_gain = gain;
        best_side = side;
        best_low_side = low_side;
      }
    }
  }
  if (best_gain > 0.0) {
    const std::uint32_t high = nodes_[node].children[best_side];
    const std::uint32_t sibling = nodes_[node].children[1 - best_side];
    attach(nodes_[sibling].children[best_low_side], node, best_side);
    attach(high, sibling, best_low_side);
    const auto [left, right] = nodes_[sibling].children;
    nodes_[sibling].box = unionOf(nodes_[left].box, nodes_[right].box);
  }
}

/// The node beside which a leaf makes the tree's surface area grow least. Descends while a child
/// can be better than its node.
std::uint32_t AabbTree::bestSibling(const SmallBox& box) const noexcept {
  std::uint32_t node = root_;
  while (!isLeaf(node)) {
    const double with_leaf = areaOf(unionOf(nodes_[node].box, box));
    const double passed_on = with_leaf - areaOf(nodes_[node].box);
    double least = with_leaf;
    std::uint32_t next = kNone;
    for (const std::uint32_t child : nodes_[node].children) {
      const double together = areaOf(unionOf(nodes_[child].box, box));
      const double cost =
          passed_on + (isLeaf(child) ? together : together - areaOf(nodes_[child].box));
      if (cost < least) {
        least = cost;
        next = child;
      }
    }
    if (next == kNone) {
      break;
    }
    node = next;
  }
  return node;
}

void AabbTree::insert(std::uint32_t leaf) noexcept {
  in_tree_[leaf] = 1;
  if (root_ == kNone) {
    attach(leaf, kNone, 0);
    return;
  }
  const std::uint32_t sibling = bestSibling(nodes_[leaf].box);
  const std::uint32_t node = free_.back();
  free_.pop_back();
  attach(node, nodes_[sibling].parent, sideOf(sibling));
  attach(sibling, node, 0);
  attach(leaf, node, 1);
  refitAbove(node);
}

void AabbTree::remove(std::uint32_t leaf) noexcept {
  in_tree_[leaf] = 0;
  const std::uint32_t parent = nodes_[leaf].parent;
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  const std::uint32_t sibling = nodes_[parent].children[1 - sideOf(leaf)];
  attach(sibling, nodes_[parent].parent, sideOf(parent));
  free_.push_back(parent);
}

void AabbTree::refitAbove(std::uint32_t node) noexcept {
  for (; node != kNone; node = nodes_[node].parent) {
    const auto [left, right] = nodes_[node].children;
    nodes_[node].box = unionOf(nodes_[left].box, nodes_[right].box);
  }
}

}  // namespace collision_monitor
