// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/part_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

void gather(const MeshTree& tree, std::uint32_t child, std::vector<std::uint32_t>& triangles) {
  if (child == kNone) {
    return;
  }
  if ((child & MeshTreeNode::kTriangle) != 0) {
    triangles.push_back(child & ~MeshTreeNode::kTriangle);
    return;
  }
  for (const std::uint32_t below : tree.nodes()[child].child) {
    gather(tree, below, triangles);
  }
}

/// The corners of a range, in the frame of the mesh.
std::vector<Vector3d> cornersIn(const MeshTree& tree, PartCorners::Range range) {
  const PartCorners& corners = tree.partCorners();
  std::vector<Vector3d> found;
  for (std::uint32_t i = range.first; i < range.last; ++i) {
    found.push_back(tree.center() +
                    Vector3d(*corners.along(0, i), *corners.along(1, i), *corners.along(2, i)));
  }
  return found;
}

bool isAmong(const std::vector<Vector3d>& points, const Vector3d& point, double rounding) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector3d& one) { return (one - point).norm() <= rounding; });
}

void expectCornersOfAllParts(const MeshTree& tree) {
  const double rounding = 1e-6 * tree.radius();
  int parts = 0;
  for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
    std::vector<std::uint32_t> triangles;
    gather(tree, node, triangles);
    const PartCorners::Range range = tree.partCorners().of(node);
    ASSERT_EQ(range.first % PartCorners::kStep, 0U);
    ASSERT_EQ(range.last % PartCorners::kStep, 0U);
    if (triangles.size() < PartCorners::kFewTriangles) {
      ASSERT_TRUE(range.empty()) << node;
    }
    if (range.empty()) {
      continue;
    }
    ++parts;
    const std::vector<Vector3d> found = cornersIn(tree, range);
    std::vector<Vector3d> held;
    for (const std::uint32_t triangle : triangles) {
      for (const Vector3d& corner : tree.triangles()[triangle]) {
        ASSERT_TRUE(isAmong(found, corner, rounding)) << node;
        held.push_back(corner);
      }
    }
    for (const Vector3d& corner : found) {
      ASSERT_TRUE(isAmong(held, corner, rounding)) << node;
    }
  }
  EXPECT_GT(parts, 3);
}

TEST(PartCorners, parts_haveTheCornersOfTheirTrianglesAndNoOthers) {
  expectCornersOfAllParts(MeshTree(bumpyMesh(0.2, 12), true));
  expectCornersOfAllParts(MeshTree(moved(sphereMesh(0.1, 14), {0.1, 0.2, 0.3}, {3, -2, 1}), true));
}

TEST(PartCorners, ofPointsWithoutTriangles) {
  TriangleMesh points = sphereMesh(0.1, 16);
  points.triangles.clear();
  expectCornersOfAllParts(MeshTree(points));
}

TEST(PartCorners, ofSmallMeshes_none) {
  const MeshTree tree(boxMesh({1, 1, 1}), true);
  for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
    EXPECT_TRUE(tree.partCorners().of(node).empty());
  }
}

TEST(PartCorners, ofLargeMeshes_onlyOfPartsWithFewCorners) {
  const MeshTree tree(bumpyMesh(0.2, 80), true);
  EXPECT_TRUE(tree.partCorners().of(0).empty());
  int parts = 0;
  for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
    const PartCorners::Range range = tree.partCorners().of(node);
    EXPECT_LE(range.last - range.first, PartCorners::kMostCorners);
    parts += range.empty() ? 0 : 1;
  }
  EXPECT_GT(parts, 100);
}

}  // namespace
}  // namespace collision_monitor::test
