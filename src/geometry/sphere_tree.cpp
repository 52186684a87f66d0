// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sphere_tree.h"

#include <algorithm>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// The nodes where the descent from the root ends.
template <class Ends>
std::vector<SphereNode> cut(const SphereTree& tree, const Ends& ends) {
  std::vector<SphereNode> result;
  std::vector<std::uint32_t> to_visit;
  if (!tree.nodes.empty()) {
    to_visit.push_back(0);
  }
  for (std::size_t i = 0; i < to_visit.size(); ++i) {
    const SphereNode& node = tree.nodes[to_visit[i]];
    if (node.child_count == 0 || ends(node)) {
      result.push_back(node);
      continue;
    }
    for (std::uint32_t child = 0; child < node.child_count; ++child) {
      to_visit.push_back(node.first_child + child);
    }
  }
  return result;
}

}  // namespace

std::uint32_t levelCount(const SphereTree& tree) noexcept {
  std::uint32_t count = 0;
  for (const auto& node : tree.nodes) {
    count = std::max(count, node.level + 1);
  }
  return count;
}

std::vector<SphereNode> spheresOfLevel(const SphereTree& tree, std::uint32_t level) {
  return cut(tree, [&](const SphereNode& node) { return node.level >= level; });
}

SphereTree placed(const SphereTree& tree, const Pose& link_from_geometry) {
  const Eigen::Matrix3d& rotation = link_from_geometry.rotation;
  // |R| <= 1 + |R^T R - I|. The computed norm is within 12 u.
  const double stretch =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() + 16.0 * kUnitRoundOff;
  SphereTree result = tree;
  for (auto& node : result.nodes) {
    const double lengths = node.center.norm() + link_from_geometry.translation.norm();
    node.center = link_from_geometry * node.center;
    // A center whose terms cancel has an error of a few u of these terms.
    const double allowance = 16.0 * kUnitRoundOff * (1.0 + stretch) * lengths;
    node.radius = node.radius * (1.0 + stretch) + allowance;
  }
  return result;
}

}  // namespace collision_monitor
