// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/narrow_phase/convex_distance.h"
#include "geometry/bvh/part_support.h"
#include "narrow_phase/mesh/part_gap.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

// Laws of the convex hulls of parts of meshes.
namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

void gather(const MeshTree& tree, std::uint32_t child, std::vector<Vector3d>& corners) {
  if (child == kNone) {
    return;
  }
  if (isTriangle(child)) {
    const Triangle& triangle = tree.triangles()[triangleAt(child)];
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    return;
  }
  for (const std::uint32_t below : tree.nodes()[child].child) {
    gather(tree, below, corners);
  }
}

std::vector<Vector3d> cornersAt(const MeshTree& tree, Slot slot) {
  std::vector<Vector3d> corners;
  gather(tree, childOf(tree, slot), corners);
  return corners;
}

/// A mesh and the slots of its parts.
struct Parted {
  explicit Parted(MeshTree given) : tree(std::move(given)) {
    for (Slot slot = 0; slot < MeshTreeNode::kWidth * tree.nodes().size(); ++slot) {
      const std::uint32_t child = childOf(tree, slot);
      if (child != kNone && !isTriangle(child) && !tree.partCorners().of(child).empty()) {
        slots.push_back(slot);
      }
    }
  }

  MeshTree tree;
  std::vector<Slot> slots;
};

class PartGapLaws : public testing::Test {
 protected:
  const Parted& anyMesh() { return meshes_[random_() % meshes_.size()]; }
  Slot anyPart(const Parted& mesh) { return mesh.slots[random_() % mesh.slots.size()]; }

  Random random_{kSeed};
  const std::vector<Parted> meshes_{
      Parted(MeshTree(bumpyMesh(0.2, 24), true)),
      Parted(MeshTree(moved(sphereMesh(0.1, 20), {0.1, 0.2, 0.3}, {0.5, -0.2, 0.1}), true)),
      Parted(openTree(triangleSoup(0.1, 200, random_)))};
};

TEST_F(PartGapLaws, farthest_isAsFarAsAnyCorner) {
  for (int i = 0; i < 3000; ++i) {
    const Parted& mesh = anyMesh();
    const Slot slot = anyPart(mesh);
    const Vector3d direction = randomPoint(random_, 1.0).normalized();
    const Vector3d found = farthestOfPart(mesh.tree, childOf(mesh.tree, slot), 3.0 * direction);
    double farthest = -std::numeric_limits<double>::infinity();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3d& corner : cornersAt(mesh.tree, slot)) {
      farthest = std::max(farthest, direction.dot(corner));
      nearest = std::min(nearest, (corner - found).norm());
    }
    ASSERT_NEAR(direction.dot(found), farthest, kPartError * mesh.tree.radius());
    ASSERT_LE(nearest, kPartError * mesh.tree.radius()) << "it is a corner";
  }
}

/// The hulls are built here, so that nothing of the search is taken on trust.
TEST_F(PartGapLaws, gap_isThatOfTheHulls) {
  ConvexWorkspace workspace;
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const Parted& a = anyMesh();
    const Parted& b = anyMesh();
    const Pose a_from_b = randomPose(random_, 0.3);
    const Pose origin;
    const MeshPair pair = makeMeshPair({a.tree, origin}, {b.tree, a_from_b});
    const Slot of_a = anyPart(a);
    const Slot of_b = anyPart(b);
    ASSERT_TRUE(areParts(pair, of_a, of_b));
    ConvexWarmStart warm;
    ConvexSearch search{workspace, warm};
    const double truth =
        signedDistanceBetween(ConvexHull(cornersAt(a.tree, of_a)), origin,
                              ConvexHull(cornersAt(b.tree, of_b)), a_from_b, search)
            .measured.distance;
    const double error = 4.0 * kPartError * (a.tree.radius() + b.tree.radius());
    const double goal = uniform(random_, 0.0, 0.3);
    const PartGap found = searchGapOfParts(pair, of_a, of_b, goal);
    ASSERT_LE(found.gap, std::max(truth, 0.0));
    if (std::abs(truth - goal) > error) {
      ASSERT_EQ(found.gap > goal, truth > goal) << truth << " and " << goal;
    }
    if (found.gap > goal) {
      ++apart;
      ASSERT_NEAR(gapOfParts(pair, of_a, of_b, 2.0 * found.direction), found.gap, error);
    }
  }
  EXPECT_GT(apart, 500);
}

TEST_F(PartGapLaws, queries_allocateNothing) {
  const Pose origin;
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    const Pose pose = randomPose(random_, 0.3);
    const MeshPair pair = makeMeshPair({meshes_[0].tree, origin}, {meshes_[1].tree, pose});
    searchGapOfParts(pair, anyPart(meshes_[0]), anyPart(meshes_[1]), 0.1);
  }
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
