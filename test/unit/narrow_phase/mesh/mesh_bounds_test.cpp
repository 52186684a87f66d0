// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_bounds.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

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

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, MeshBounds, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

std::vector<NodeBounds> boundsOfAllNodes(const MeshTree& tree, std::int64_t instruction_set) {
  const OnlyInstructionSet only(instruction_set);
  Random random(20260101);
  std::vector<NodeBounds> all;
  for (const MeshTreeNode& node : tree.nodes()) {
    const Pose pose = randomPose(random, 1.0);
    boundNearer(node, place(makePlacement(pose, 3.0), boundOf(node, 0)), 0.1F, all.emplace_back());
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

}  // namespace
}  // namespace collision_monitor::test
