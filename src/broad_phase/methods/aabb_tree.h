// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/small_box.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// A binary tree of boxes over bodies of any size. Boxes are refitted in every call. A node is
/// swapped with a child of its sibling where that makes the sibling smaller (a rotation). Bodies
/// that become known are inserted where they add the least surface area; unknown ones are removed.
/// A tree that has become much looser than when it was built is rebuilt.
///
/// Source: Kopta, Ize, Spjut, Brunvand, Davis, Kensler, "Fast, Effective BVH Updates for Animated
/// Scenes" (2012) for rotations; Catto, "Dynamic Bounding Volume Hierarchies" (2019) for insertion.
class AabbTree {
 public:
  explicit AabbTree(std::size_t body_count);

  /// Every pair of boxes that meet, in no order.
  /// @pre as many boxes as given to the constructor.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

 private:
  /// Node i is the leaf of body i, if i is below the number of bodies.
  struct Node {
    SmallBox box;
    std::uint32_t parent{kNone};
    std::array<std::uint32_t, 2> children{kNone, kNone};
  };
  /// A part of leaves_ that becomes a subtree below `parent`.
  struct Span {
    std::size_t first;
    std::size_t last;
    std::uint32_t parent;
    std::size_t side;
  };

  bool isLeaf(std::uint32_t node) const noexcept { return node < in_tree_.size(); }
  void update(const std::vector<SmallBox>& boxes) noexcept;
  void build(const std::vector<SmallBox>& boxes) noexcept;
  std::size_t splitSpan(const Span& span) noexcept;
  double refit() noexcept;
  void rotate(std::uint32_t node) noexcept;
  void insert(std::uint32_t leaf) noexcept;
  std::uint32_t bestSibling(const SmallBox& box) const noexcept;
  void remove(std::uint32_t leaf) noexcept;
  void refitAbove(std::uint32_t node) noexcept;
  void attach(std::uint32_t node, std::uint32_t parent, std::size_t side) noexcept;
  std::size_t sideOf(std::uint32_t node) const noexcept;

  std::vector<Node> nodes_;
  std::vector<unsigned char> in_tree_;  ///< by body
  std::vector<std::uint32_t> free_;     ///< unused inner nodes
  std::uint32_t root_{kNone};
  double built_area_{0.0};  ///< [m^2] total of the inner nodes when the tree was built
  std::vector<std::uint32_t> leaves_;
  std::vector<std::uint32_t> order_;
  std::vector<Span> spans_;
  std::vector<std::array<std::uint32_t, 2>> stack_;
};

}  // namespace collision_monitor
