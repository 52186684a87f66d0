// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "broad_phase/tree_nodes.h"
#include "collision_monitor/broad_phase/small_box.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// Bodies that a search found, in order.
struct FoundBodies {
  const std::uint32_t* first;
  const std::uint32_t* last;
  const std::uint32_t* begin() const noexcept { return first; }
  const std::uint32_t* end() const noexcept { return last; }
};

/// A tree of boxes over bodies that keep their places to each other. It stands in a frame that
/// moves with them, so it is made once and never refitted. Eight bodies in a row share a node,
/// eight nodes in a row share one of the level above, and so on: no node names its children. A
/// search tests the children of a node at once. It is fast if bodies in a row are neighbours.
class RigidTree {
 public:
  /// @param boxes in the frame of the tree. Bodies are numbered in their order.
  explicit RigidTree(const std::vector<Aabb>& boxes);

  /// The numbers that findNear needs room for.
  std::size_t roomForFound() const noexcept { return kTreeChildren * (nodes_.size() + 2); }

  /// Finds each body whose box is as near as the oriented box asks, and few that are not.
  /// @param room for the search. Its last numbers are the bodies.
  /// @pre `room` holds roomForFound() numbers.
  FoundBodies findNear(const NearBox& box, std::vector<std::uint32_t>& room) const noexcept;

  /// Calls `visit(body)` for each body whose box is at most `within` [m] from the point. The visit
  /// may lower `within`; nothing is within less than 0.
  /// @param point in the frame of the tree
  template <class Visit>
  void visitNear(const Eigen::Vector3d& point, const double& within, const Visit& visit) const {
    if (!levels_.empty()) {
      visitNearIn({levels_.size() - 1, 0}, point, within, visit);
    }
  }

 private:
  struct Place {
    std::size_t level;
    std::size_t node;  ///< of its level
  };

  /// By child. [m^2] NaN for missing children.
  static void squaredDistances(const TreeNode& node, const Eigen::Vector3d& point,
                               double (&squared)[kTreeChildren]) noexcept;

  template <class Visit>
  void visitNearIn(Place place, const Eigen::Vector3d& point, const double& within,
                   const Visit& visit) const {
    double squared[kTreeChildren];
    squaredDistances(nodes_[levels_[place.level] + place.node], point, squared);
    for (std::size_t child = 0; child < kTreeChildren; ++child) {
      if (!(within >= 0.0 && squared[child] <= within * within)) {
        continue;
      }
      const std::size_t at = kTreeChildren * place.node + child;
      if (place.level == 0) {
        visit(static_cast<std::uint32_t>(at));
      } else {
        visitNearIn({place.level - 1, at}, point, within, visit);
      }
    }
  }

  std::vector<TreeNode> nodes_;      ///< level by level
  std::vector<std::size_t> levels_;  ///< the first node of each level; bodies are children of the
                                     ///< lowest, the highest has one node
};

}  // namespace collision_monitor
