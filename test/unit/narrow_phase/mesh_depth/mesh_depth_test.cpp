// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/mesh_depth.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "narrow_phase/mesh_depth/mesh_way_out.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/mesh_overlap.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class MeshDepthTest : public testing::Test {
 protected:
  /// How deep the meshes are in each other, at least and at most.
  struct Depths {
    double at_least;
    WayOut out;
    MeshDepth found;
  };
  Depths depths(const MeshTree& a, const Pose& pose_a, const MeshTree& b, const Pose& pose_b,
                std::uint32_t budget = 200000) {
    const auto nothing = std::make_unique<KeptDepth>();
    const MeshDepth found = depthOf({a, pose_a}, {b, pose_b}, *memory_, *nothing, budget);
    return {-found.deepest.distance, wayOut({a, pose_a}, {b, pose_b}, found.deepest.normal_a_to_b),
            found};
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  const MeshTree cube_{boxMesh({1, 1, 1}), true};
  const MeshTree small_{boxMesh({0.1, 0.2, 0.3}), true};
};

TEST_F(MeshDepthTest, cornersInsideACube_bothBoundsMeet) {
  // The small box reaches 0.05 into the face x = 1; its corners are 0.7 and more from others.
  const Depths found = depths(cube_, at(0, 0, 0), small_, at(1.05, 0, 0));
  EXPECT_TRUE(found.found.is_complete);
  EXPECT_NEAR(found.at_least, 0.05, kExact);
  EXPECT_NEAR(found.out.length, 0.05, kExact);
  expectNear(found.out.direction, {1, 0, 0}, "way out");
  expectNear(found.found.deepest.normal_a_to_b, {1, 0, 0}, "normal");
  expectConsistent(found.found.deepest);
  EXPECT_NEAR(found.found.deepest.point_on_a.x(), 1.0, kExact);
}

TEST_F(MeshDepthTest, otherOrder_turnsTheNormal) {
  const Depths found = depths(small_, at(1.05, 0, 0), cube_, at(0, 0, 0));
  EXPECT_NEAR(found.at_least, 0.05, kExact);
  EXPECT_NEAR(found.out.length, 0.05, kExact);
  expectNear(found.found.deepest.normal_a_to_b, {-1, 0, 0}, "normal");
  expectConsistent(found.found.deepest);
}

TEST_F(MeshDepthTest, oneInsideTheOther_isBoundedToo) {
  // Center 0.5 from the face: the far corners are 0.6 deep, or 0.7 and 0.8 from others.
  const Depths found = depths(cube_, at(0, 0, 0), small_, at(0.5, 0, 0));
  EXPECT_NEAR(found.at_least, 0.6, kExact);
  EXPECT_NEAR(found.out.length, 0.6, kExact);
}

TEST_F(MeshDepthTest, crossedBars_lowerBoundSaysNothingUpperBoundHolds) {
  const MeshTree along_x(boxMesh({2, 0.1, 0.1}), true);
  const MeshTree along_y(boxMesh({0.1, 2, 0.1}), true);
  const Depths found = depths(along_x, at(0, 0, 0), along_y, at(0, 0, 0.15));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.out.length, 0.05, kExact);
  expectNear(found.out.direction, {0, 0, 1}, "way out");
}

TEST_F(MeshDepthTest, apart_isNotDeep) {
  const Depths found = depths(cube_, at(0, 0, 0), small_, at(1.5, 0, 0));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.out.length, -0.4, kExact);
}

TEST_F(MeshDepthTest, openMeshes_haveNoInside) {
  const MeshTree open(boxMesh({1, 1, 1}), false);
  const MeshTree small_open(boxMesh({0.1, 0.2, 0.3}), false);
  const Depths found = depths(open, at(0, 0, 0), small_open, at(1.05, 0, 0));
  EXPECT_EQ(found.at_least, 0.0);
  EXPECT_NEAR(found.out.length, 0.05, kExact);
}

TEST_F(MeshDepthTest, poseNotFinite_isNotComplete) {
  const Pose bad = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Depths found = depths(cube_, bad, small_, at(0, 0, 0));
  EXPECT_FALSE(found.found.is_complete);
  EXPECT_EQ(found.at_least, 0.0);
}

TEST_F(MeshDepthTest, smallBudget_stillGivesBounds) {
  const MeshTree body(bumpyMesh(1.0, 30), true);
  const Pose turned{eighthTurn(), {0.5, 0.1, 0.05}};
  const Depths all = depths(body, at(0, 0, 0), body, turned);
  const Depths some = depths(body, at(0, 0, 0), body, turned, 10);
  EXPECT_TRUE(all.found.is_complete);
  EXPECT_FALSE(some.found.is_complete);
  EXPECT_LE(some.at_least, all.at_least);
  EXPECT_LE(all.at_least, all.out.length);
}

// What the bounds mean, with nothing but the overlap test.
TEST_F(MeshDepthTest, bodiesInEachOther_areHeldByLessAndFreedByMore) {
  const MeshTree body(bumpyMesh(1.0, 20), true);
  Random random(20260101);
  int deep = 0;
  for (int i = 0; i < 40; ++i) {
    const Pose a = randomPose(random, 1.0);
    const Pose b{randomRotation(random), a.translation + randomPoint(random, 0.5)};
    const Depths found = depths(body, a, body, b);
    ASSERT_TRUE(found.found.is_complete);
    ASSERT_LE(found.at_least, found.out.length + kExact);
    const auto moved = [&](const Vector3d& delta) {
      return Pose{b.rotation, b.translation + delta};
    };
    ASSERT_FALSE(meshesOverlap(
        {body, a}, {body, moved((found.out.length + 1e-9) * found.out.direction)}, *memory_));
    for (int k = 0; k < 10 && found.at_least > 0.0; ++k, ++deep) {
      const Vector3d delta = 0.999 * found.at_least * randomPoint(random, 1.0).normalized();
      ASSERT_TRUE(meshesOverlap({body, a}, {body, moved(delta)}, *memory_));
    }
  }
  EXPECT_GT(deep, 100);
}

TEST_F(MeshDepthTest, deepestCorner_isThatOfAllCorners) {
  const TriangleMesh mesh = bumpyMesh(1.0, 12);
  const MeshTree body(mesh, true);
  const Pose b{eighthTurn(), {0.4, 0.2, 0.1}};
  const Depths found = depths(cube_, at(0.3, 0.9, 0.8), body, b);
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

TEST_F(MeshDepthTest, allocatesNothing) {
  const auto nothing = std::make_unique<KeptDepth>();
  const Pose origin;
  const Pose inside = at(1.05, 0, 0);
  const AllocationGuard guard;
  depthOf({cube_, origin}, {small_, inside}, *memory_, *nothing, 1000);
  wayOut({cube_, origin}, {small_, inside}, {1, 0, 0});
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
