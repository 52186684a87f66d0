// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/box_tests.h"
#include "collision_monitor/broad_phase/small_box.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// A tree of boxes over bodies that keep their places to each other. It stands in a frame that
/// moves with them, so it is made once and never refitted. Nodes stand in depth-first order, and
/// each names the node that follows its subtree: a search needs no stack.
///
/// Source: Smits, "Efficiency Issues for Ray Tracing" (1998), section 5, for the order of nodes.
class RigidTree {
 public:
  /// @param boxes in the frame of the tree. Bodies are numbered in their order.
  explicit RigidTree(const std::vector<Aabb>& boxes);

  /// Calls `visit(body)` for each body whose box meets this one.
  /// @param box in the frame of the tree
  template <class Visit>
  void visitMeeting(const SmallBox& box, const Visit& visit) const {
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      const bool is_met = meets(node.box, box);
      if (is_met && node.body != kNone) {
        visit(node.body);
      }
      i = is_met ? i + 1 : node.next;
    }
  }

  /// Calls `visit(body)` for each body whose box is at most `within` [m] from the point. The visit
  /// may lower `within`; nothing is within less than 0.
  /// @param point in the frame of the tree
  template <class Visit>
  void visitNear(const Eigen::Vector3d& point, const double& within, const Visit& visit) const {
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      const bool is_near = within >= 0.0 && squaredDistance(node.box, point) <= within * within;
      if (is_near && node.body != kNone) {
        visit(node.body);
      }
      i = is_near ? i + 1 : node.next;
    }
  }

 private:
  struct Node {
    SmallBox box;
    std::uint32_t next{0};      ///< the node after its subtree
    std::uint32_t body{kNone};  ///< of a leaf
  };

  static double squaredDistance(const SmallBox& box, const Eigen::Vector3d& point) noexcept;
  void build(const std::vector<SmallBox>& boxes, std::uint32_t* first, std::uint32_t* last);

  std::vector<Node> nodes_;
};

}  // namespace collision_monitor
