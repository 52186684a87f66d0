// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sphere_tree.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

/// A root with two children, the first of which has two of its own.
SphereTree smallTree() {
  SphereTree tree;
  tree.nodes.push_back({{0, 0, 0}, 8.0, 4.0, 1, 2, 0});
  tree.nodes.push_back({{-4, 0, 0}, 5.0, 2.0, 3, 2, 1});
  tree.nodes.push_back({{4, 0, 0}, 3.0, 1.0, 0, 0, 1});
  tree.nodes.push_back({{-6, 0, 0}, 2.0, 0.5, 0, 0, 2});
  tree.nodes.push_back({{-2, 0, 0}, 2.0, 0.7, 0, 0, 2});
  return tree;
}

std::vector<double> radiiOf(const std::vector<SphereNode>& nodes) {
  std::vector<double> radii;
  for (const auto& node : nodes) {
    radii.push_back(node.radius);
  }
  return radii;
}

TEST(SphereTree, levelsTakeTheLeavesAboveThem) {
  const SphereTree tree = smallTree();
  EXPECT_EQ(levelCount(tree), 3u);
  EXPECT_EQ(radiiOf(spheresOfLevel(tree, 0)), (std::vector<double>{8}));
  EXPECT_EQ(radiiOf(spheresOfLevel(tree, 1)), (std::vector<double>{5, 3}));
  EXPECT_EQ(radiiOf(spheresOfLevel(tree, 2)), (std::vector<double>{3, 2, 2}));
  EXPECT_EQ(radiiOf(spheresOfLevel(tree, 99)), (std::vector<double>{3, 2, 2}));
}

TEST(SphereTree, withoutNodes_hasNoLevelsAndNoSpheres) {
  EXPECT_EQ(levelCount(SphereTree{}), 0u);
  EXPECT_TRUE(spheresOfLevel(SphereTree{}, 0).empty());
  EXPECT_TRUE(placed(SphereTree{}, Pose{}).nodes.empty());
}

TEST(SphereTree, placed_turnsAndShiftsCenters_andNeverShrinks) {
  Pose link_from_geometry;
  link_from_geometry.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  link_from_geometry.translation = {10, 20, 30};
  const SphereTree tree = placed(smallTree(), link_from_geometry);
  EXPECT_EQ(tree.nodes[2].center, Eigen::Vector3d(10, 24, 30));
  EXPECT_GT(tree.nodes[2].radius, 3.0);
  EXPECT_LT(tree.nodes[2].radius, 3.0 + 1e-13);
  EXPECT_EQ(tree.nodes[1].first_child, 3u);
}

TEST(SphereTree, placedByARotationThatStretches_growsAsMuch) {
  Pose link_from_geometry;
  link_from_geometry.rotation *= 1.0 + 1e-6;
  EXPECT_GE(placed(smallTree(), link_from_geometry).nodes[0].radius, 8.0 * (1.0 + 1e-6));
}

}  // namespace
}  // namespace collision_monitor
