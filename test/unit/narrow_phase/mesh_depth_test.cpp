// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/mesh_depth.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class MeshDepth : public testing::Test {
 protected:
  MeshPenetration depth(const MeshTree& a, const Pose& pose_a, const MeshTree& b,
                        const Pose& pose_b, std::uint32_t budget = 100000) {
    return penetrationOf({a, pose_a}, {b, pose_b}, *memory_, budget);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  const MeshTree cube_{boxMesh({1, 1, 1}), true};
  const MeshTree small_{boxMesh({0.1, 0.2, 0.3}), true};
};

TEST_F(MeshDepth, cornersInsideACube_bothBoundsMeet) {
  // The small box reaches 0.05 into the face x = 1; its corners are 0.7 and more from others.
  const MeshPenetration found = depth(cube_, at(0, 0, 0), small_, at(1.05, 0, 0));
  EXPECT_TRUE(found.is_complete);
  EXPECT_NEAR(found.at_least, 0.05, kExact);
  EXPECT_NEAR(found.at_most, 0.05, kExact);
  expectNear(found.way_out, {1, 0, 0}, "way out");
  expectNear(found.deepest.normal_a_to_b, {1, 0, 0}, "normal");
  expectConsistent(found.deepest);
  EXPECT_NEAR(found.deepest.point_on_a.x(), 1.0, kExact);
}

TEST_F(MeshDepth, otherOrder_turnsTheNormal) {
  const MeshPenetration found = depth(small_, at(1.05, 0, 0), cube_, at(0, 0, 0));
  EXPECT_NEAR(found.at_least, 0.05, kExact);
  EXPECT_NEAR(found.at_most, 0.05, kExact);
  expectNear(found.deepest.normal_a_to_b, {-1, 0, 0}, "normal");
  expectConsistent(found.deepest);
}

TEST_F(MeshDepth, oneInsideTheOther_isBoundedToo) {
  // Centre 0.5 from the face: the far corners are 0.6 deep, or 0.7 and 0.8 from others.
  const MeshPenetration found = depth(cube_, at(0, 0, 0), small_, at(0.5, 0, 0));
  EXPECT_NEAR(found.at_least, 0.6, kExact);
  EXPECT_NEAR(found.at_most, 0.6, kExact);
}

TEST_F(MeshDepth, crossedBars_lowerBoundSaysNothingUpperBoundHolds) {
  const MeshTree along_x(boxMesh({2, 0.1, 0.1}), true);
  const MeshTree along_y(boxMesh({0.1, 2, 0.1}), true);
  const MeshPenetration found = depth(along_x, at(0, 0, 0), along_y, at(0, 0, 0.15));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.at_most, 0.05, kExact);
  expectNear(found.way_out, {0, 0, 1}, "way out");
}

TEST_F(MeshDepth, apart_isNotDeep) {
  const MeshPenetration found = depth(cube_, at(0, 0, 0), small_, at(1.5, 0, 0));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.at_most, -0.4, kExact);
}

TEST_F(MeshDepth, openMeshes_haveNoInside) {
  const MeshTree open(boxMesh({1, 1, 1}), false);
  const MeshTree small_open(boxMesh({0.1, 0.2, 0.3}), false);
  const MeshPenetration found = depth(open, at(0, 0, 0), small_open, at(1.05, 0, 0));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.at_most, 0.05, kExact);
}

TEST_F(MeshDepth, poseNotFinite_isNotComplete) {
  const Pose bad = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const MeshPenetration found = depth(cube_, bad, small_, at(0, 0, 0));
  EXPECT_FALSE(found.is_complete);
  EXPECT_EQ(found.at_least, 0.0);
}

TEST_F(MeshDepth, smallBudget_stillGivesBounds) {
  const MeshTree body(bumpyMesh(1.0, 30), true);
  const Pose turned{eighthTurn(), {0.5, 0.1, 0.05}};
  const MeshPenetration all = depth(body, at(0, 0, 0), body, turned);
  const MeshPenetration some = depth(body, at(0, 0, 0), body, turned, 5);
  EXPECT_TRUE(all.is_complete);
  EXPECT_FALSE(some.is_complete);
  EXPECT_LE(some.at_least, all.at_least);
  EXPECT_LE(all.at_least, all.at_most);
}

// What the bounds mean, with nothing but the overlap test.
TEST_F(MeshDepth, bodiesInEachOther_areHeldByLessAndFreedByMore) {
  const MeshTree body(bumpyMesh(1.0, 20), true);
  Random random(20260101);
  int deep = 0;
  for (int i = 0; i < 40; ++i) {
    const Pose a = randomPose(random, 1.0);
    const Pose b{randomRotation(random), a.translation + randomPoint(random, 0.5)};
    const MeshPenetration found = depth(body, a, body, b);
    ASSERT_TRUE(found.is_complete);
    ASSERT_LE(found.at_least, found.at_most + kExact);
    const auto moved = [&](const Vector3d& way) { return Pose{b.rotation, b.translation + way}; };
    ASSERT_FALSE(
        overlap({body, a}, {body, moved((found.at_most + 1e-9) * found.way_out)}, *memory_));
    for (int k = 0; k < 10 && found.at_least > 0.0; ++k, ++deep) {
      const Vector3d way = 0.999 * found.at_least * randomPoint(random, 1.0).normalized();
      ASSERT_TRUE(overlap({body, a}, {body, moved(way)}, *memory_));
    }
  }
  EXPECT_GT(deep, 100);
}

TEST_F(MeshDepth, deepestCorner_isThatOfAllCorners) {
  const TriangleMesh mesh = bumpyMesh(1.0, 12);
  const MeshTree body(mesh, true);
  const Pose b{eighthTurn(), {0.4, 0.2, 0.1}};
  const MeshPenetration found = depth(cube_, at(0.3, 0.9, 0.8), body, b);
  double deepest = 0.0;
  const Shape point = Sphere{0.0};
  const auto measure = [&](const MeshTree& tree, const Pose& pose, const Vector3d& corner) {
    const Pose at_corner{Eigen::Matrix3d::Identity(), corner};
    deepest = std::max(
        deepest, -distanceBetween({tree, pose}, {point, at_corner}, *memory_).measured.distance);
  };
  for (const Vector3d& vertex : mesh.vertices) {
    measure(cube_, at(0.3, 0.9, 0.8), b * vertex);
  }
  for (const Vector3d& vertex : boxMesh({1, 1, 1}).vertices) {
    measure(body, b, at(0.3, 0.9, 0.8) * vertex);
  }
  EXPECT_GT(deepest, 0.05);
  EXPECT_NEAR(found.at_least, deepest, kExact);
}

TEST_F(MeshDepth, allocatesNothing) {
  const AllocationGuard guard;
  depth(cube_, at(0, 0, 0), small_, at(1.05, 0, 0));
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
