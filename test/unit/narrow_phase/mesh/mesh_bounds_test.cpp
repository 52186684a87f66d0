// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "support/instruction_sets.h"
#include "support/query_meshes.h"

namespace collision_monitor::test {
namespace {

constexpr float kSlack = 1e-4F;  // more than BoundPlacement::slack takes in these scenes

// Slot k holds a cube of half extent 1 m about (0, 10 k, 0), with a slab across z.
MeshTreeNode nodeOfCubes() {
  MeshTreeNode node{};
  for (std::uint32_t k = 0; k < MeshTreeNode::kWidth; ++k) {
    node.center[1][k] = 10.0F * static_cast<float>(k);
    node.half[0][k] = node.half[1][k] = node.half[2][k] = 1.0F;
    node.normal[2][k] = 1.0F;
    node.slab_half[k] = 1.0F;
  }
  return node;
}

PlacedBound cubeAt(const Pose& pose) {
  const Bound cube{{0, 0, 0}, {1, 1, 1}, {0, 0, 1}, 0.0F, 1.0F};
  return place(makePlacement(pose, 20.0), cube);
}

PlacedTriangle trianglePlacedBy(const Pose& pose, const Triangle& triangle) {
  return place(makePlacement(pose, 20.0), Eigen::Vector3d::Zero(), triangle);
}

class MeshBounds : public testing::TestWithParam<std::int64_t> {
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(MeshBounds, cubesApartAlongAnAxis_gapOfTheirFaces) {
  NodeBounds bounds;
  const PlacedBound other = cubeAt({Eigen::Matrix3d::Identity(), {5, 0, 0}});
  const std::uint32_t nearer = boundNearer(nodeOfCubes(), other, 10.0F, bounds);
  EXPECT_EQ(nearer, 1U);  // 3 m from the first, sqrt(9 + 64) m from the second
  EXPECT_NEAR(bounds.squared[0], 9.0F, 1e-2F);
  EXPECT_LT(bounds.squared[0], 9.0F);
  EXPECT_NEAR(bounds.squared[1], 73.0F, 1e-2F);
  EXPECT_LT(bounds.squared[1], 73.0F);
  EXPECT_NEAR(bounds.order[0], 3.0F, kSlack);
}

TEST_P(MeshBounds, limitBetweenTwoBounds_dividesThem) {
  NodeBounds bounds;
  const PlacedBound other = cubeAt({Eigen::Matrix3d::Identity(), {5, 35, 0}});
  // Cubes 3 and 4 are 3 m away along x and 3 m along y; 2 and 5 are 3 m and 13 m.
  EXPECT_EQ(boundNearer(nodeOfCubes(), other, 18.5F, bounds), 0x18U);
  EXPECT_EQ(boundNearer(nodeOfCubes(), other, 180.0F, bounds), 0x3cU);
}

TEST_P(MeshBounds, slabThinnerThanItsBox_tellsTheGapAlongItsNormal) {
  MeshTreeNode node = nodeOfCubes();
  node.slab_half[0] = 0.25F;
  NodeBounds bounds;
  // The boxes touch at z = 1 m; the first child's slab ends at 0.25 m.
  const PlacedBound other = cubeAt({Eigen::Matrix3d::Identity(), {0, 0, 2}});
  boundNearer(node, other, 1.0F, bounds);
  EXPECT_NEAR(bounds.squared[0], 0.5625F, 1e-3F);
  EXPECT_LE(bounds.squared[0], 0.5625F);
}

TEST_P(MeshBounds, emptySlots_areFar) {
  const MeshTree tree(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  NodeBounds bounds;
  EXPECT_EQ(boundNearer(tree.nodes()[0], cubeAt(Pose{}), 1e30F, bounds), 1U);
  EXPECT_GT(bounds.squared[7], 1e35F);
}

TEST_P(MeshBounds, childInTheBoxOfASlantedTriangle_isFarFromItsEdge) {
  const Triangle triangle{{{10, 0, 0}, {0, 10, 0}, {10, 10, 0}}};
  NodeBounds bounds;
  boundNearer(nodeOfCubes(), trianglePlacedBy(Pose{}, triangle), 1.0F, bounds);
  EXPECT_NEAR(bounds.squared[0], 32.0F, 1e-2F);  // from the edge x + y = 10 to the corner (1, 1)
  EXPECT_LT(bounds.squared[0], 32.0F);
  EXPECT_EQ(bounds.squared[1], 0.0F);
}

TEST_P(MeshBounds, triangleBesideACorner_gapFromItsCorner) {
  NodeBounds bounds;
  const Triangle triangle{{{4, -3, 3}, {9, -9, 1}, {9, -7, 9}}};
  const std::uint32_t nearer =
      boundNearer(nodeOfCubes(), trianglePlacedBy(Pose{}, triangle), 17.5F, bounds);
  EXPECT_EQ(nearer, 1U);
  EXPECT_NEAR(bounds.squared[0], 17.0F, 0.5F);  // along the line of the middle and the corner
  EXPECT_LT(bounds.squared[0], 17.0F);
}

TEST_P(MeshBounds, slabAcrossTheDirection_gapOfTheBoxes) {
  MeshTreeNode node = nodeOfCubes();
  node.normal[0][0] = 0.6F;
  node.normal[2][0] = 0.8F;
  node.slab_half[0] = 1.4F;
  const PlacedBound other = cubeAt({Eigen::Matrix3d::Identity(), {5, 0, 0}});
  const auto gaps = gapsAlong(node, other, Eigen::Vector3f::UnitX());
  EXPECT_NEAR(gaps[0], 3.0F, 1e-3F);
  EXPECT_LE(gaps[0], 3.0F);
}

TEST_P(MeshBounds, slantedTriangle_gapToItsEdge) {
  const Triangle triangle{{{10, 0, 0}, {0, 10, 0}, {10, 10, 0}}};
  const Eigen::Vector3f diagonal = Eigen::Vector3f(1, 1, 0).normalized();
  const auto gaps = gapsAlong(nodeOfCubes(), trianglePlacedBy(Pose{}, triangle), diagonal);
  EXPECT_NEAR(gaps[0], std::sqrt(32.0F), 1e-3F);
  EXPECT_LE(gaps[0], std::sqrt(32.0F));
}

TEST_P(MeshBounds, oneChildAlongManyDirections_asEachAlone) {
  Random random(20260101);
  const MeshTreeNode node = nodeOfCubes();
  const PlacedTriangle triangle =
      trianglePlacedBy(Pose{}, Triangle{{{4, -3, 3}, {9, -9, 1}, {9, -7, 9}}});
  const PlacedBound cube = cubeAt({Eigen::Matrix3d::Identity(), {5, 35, 0}});
  Directions directions;
  std::array<Eigen::Vector3f, kDirections> units;
  for (std::size_t i = 0; i < kDirections; ++i) {
    units[i] = randomPoint(random, 1.0).normalized().cast<float>();
    for (int axis = 0; axis < 3; ++axis) {
      directions.at[axis][i] = units[i][axis];
    }
  }
  const auto at_triangle = gapsAlong(boundOf(node, 2), triangle, directions);
  const auto at_cube = gapsAlong(boundOf(node, 2), cube, directions);
  for (std::size_t i = 0; i < kDirections; ++i) {
    EXPECT_EQ(at_triangle[i], gapsAlong(node, triangle, units[i])[2]);
    EXPECT_EQ(at_cube[i], gapsAlong(node, cube, units[i])[2]);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, MeshBounds, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

/// Against a box, then against a triangle.
std::vector<NodeBounds> boundsOfAllNodes(const MeshTree& tree, std::int64_t instruction_set) {
  const OnlyInstructionSet only(instruction_set);
  Random random(20260101);
  std::vector<NodeBounds> all;
  for (const MeshTreeNode& node : tree.nodes()) {
    const Pose pose = randomPose(random, 1.0);
    const BoundPlacement placement = makePlacement(pose, 3.0);
    const Triangle& triangle = tree.triangles()[random() % tree.triangles().size()];
    boundNearer(node, place(placement, boundOf(node, 0)), 0.1F, all.emplace_back());
    boundNearer(node, place(placement, tree.center(), triangle), 0.1F, all.emplace_back());
  }
  return all;
}

TEST(MeshBoundsOfATree, everyInstructionSet_givesTheSameBits) {
  const MeshTree tree(bumpyMesh(1.0, 24));
  const std::vector<NodeBounds> best = boundsOfAllNodes(tree, instructionSets().front());
  for (const std::int64_t instruction_set : instructionSets()) {
    const std::vector<NodeBounds> found = boundsOfAllNodes(tree, instruction_set);
    EXPECT_EQ(std::memcmp(found.data(), best.data(), best.size() * sizeof(NodeBounds)), 0)
        << hwy::TargetName(instruction_set);
  }
}

/// [m^2] The least squared distance of a triangle and all below a child.
double squaredDistance(const MeshTree& tree, std::uint32_t child, const Triangle& triangle) {
  if (isTriangle(child)) {
    return nearestPoints(tree.triangles()[triangleAt(child)], triangle).squared_distance;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t below : tree.nodes()[child].child) {
    least = below == kNone ? least : std::min(least, squaredDistance(tree, below, triangle));
  }
  return least;
}

/// Counts children, and those whose bound is more than half of their distance.
struct Tightness {
  int children{0};
  int tight{0};
};

void expectBelowDistances(const MeshTree& tree, const Pose& tree_from_triangle,
                          const Triangle& triangle, const Eigen::Vector3f& direction,
                          Tightness& tightness) {
  const Pose from_center{Eigen::Matrix3d::Identity(), -tree.center()};
  const PlacedTriangle other = place(makePlacement(from_center * tree_from_triangle, 5.0),
                                     Eigen::Vector3d::Zero(), triangle);
  const Triangle in_tree{tree_from_triangle * triangle[0], tree_from_triangle * triangle[1],
                         tree_from_triangle * triangle[2]};
  for (const MeshTreeNode& node : tree.nodes()) {
    NodeBounds bounds;
    boundNearer(node, other, 1.0F, bounds);
    const auto gaps = gapsAlong(node, other, direction);
    for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
      if (node.child[slot] != kNone) {
        const double squared = squaredDistance(tree, node.child[slot], in_tree);
        ASSERT_LE(static_cast<double>(gaps[slot]), std::sqrt(squared));
        ASSERT_LE(static_cast<double>(bounds.squared[slot]), squared);
        ++tightness.children;
        tightness.tight += static_cast<double>(bounds.squared[slot]) >= 0.25 * squared ? 1 : 0;
      }
    }
  }
}

TEST(MeshBoundsOfATree, triangles_areNoNearerThanTheirBounds) {
  Random random(20260101);
  Tightness tightness;
  for (const MeshTree& tree :
       {MeshTree(bumpyMesh(1.0, 12)), MeshTree(triangleSoup(0.5, 200, random))}) {
    for (int i = 0; i < 100; ++i) {
      const double size = std::pow(10.0, uniform(random, -3.0, 0.0));
      const Triangle triangle{randomPoint(random, size), randomPoint(random, size),
                              randomPoint(random, size)};
      const Pose pose = randomPose(random, 1.0);
      const Eigen::Vector3f direction = (pose * triangle[0]).normalized().cast<float>();
      expectBelowDistances(tree, pose, triangle, direction, tightness);
    }
  }
  EXPECT_GT(tightness.tight, 9 * tightness.children / 10);
}

}  // namespace
}  // namespace collision_monitor::test
