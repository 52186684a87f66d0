// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/point_on_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "collision_monitor/geometry/ids.h"
#include "geometry/point_triangle.h"
#include "support/expect_distance.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class PointOnMeshTest : public testing::Test {
 protected:
  PointOnMesh nearest(const MeshTree& mesh, const Vector3d& point, std::uint32_t start = kNone,
                      const PointQueryLimits& limits = {}) {
    return nearestOnMesh(mesh, point, start, limits, *memory_);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  const MeshTree box_{boxMesh({1, 2, 3}), true};
};

TEST_F(PointOnMeshTest, outside_isOnTheFaceEdgeOrCorner) {
  expectNear(nearest(box_, {1.5, 0.3, 0.4}).point, {1, 0.3, 0.4}, "face");
  expectNear(nearest(box_, {4, 6, 0.4}).point, {1, 2, 0.4}, "edge");
  expectNear(nearest(box_, {2, 4, 5}).point, {1, 2, 3}, "corner");
  EXPECT_NEAR(nearest(box_, {4, 6, 0.4}).distance, 5.0, kExact);
  EXPECT_NEAR(nearest(box_, {2, 4, 5}).distance, 3.0, kExact);
}

TEST_F(PointOnMeshTest, inside_distanceIsNotSigned) {
  const PointOnMesh found = nearest(box_, {0.7, -0.5, 0.5});
  EXPECT_NEAR(found.distance, 0.3, kExact);
  expectNear(found.point, {1, -0.5, 0.5}, "point");
}

TEST_F(PointOnMeshTest, onTheSurface_isZero) { EXPECT_EQ(nearest(box_, {1, 2, 3}).distance, 0.0); }

TEST_F(PointOnMeshTest, startThatIsNearEnough_isAllThatIsLookedAt) {
  const PointOnMesh first = nearest(box_, {1.5, 0.3, 0.4});
  const PointOnMesh again = nearest(box_, {1.5, 0.3, 0.4}, first.triangle, {0.6});
  EXPECT_EQ(again.visits, 0U);
  EXPECT_EQ(again.triangle, first.triangle);
  EXPECT_NEAR(again.distance, 0.5, kExact);
}

TEST_F(PointOnMeshTest, fartherThanLookedFor_isNotFound) {
  const PointOnMesh far = nearest(box_, {1.5, 0.3, 0.4}, kNone, {0.0, 0.499});
  EXPECT_EQ(far.triangle, kNone);
  EXPECT_EQ(far.distance, std::numeric_limits<double>::infinity());
  const PointOnMesh from_far = nearest(box_, {1.5, 0.3, 0.4}, 0, {0.0, 0.499});
  EXPECT_EQ(from_far.triangle, kNone) << "nor where the search begins";
  EXPECT_NEAR(nearest(box_, {1.5, 0.3, 0.4}, kNone, {0.0, 0.501}).distance, 0.5, kExact);
}

TEST_F(PointOnMeshTest, anyPointAndStart_isTheNearestOfAllTriangles) {
  Random random(20260101);
  const MeshTree body(bumpyMesh(1.0, 16), true);
  for (int i = 0; i < 300; ++i) {
    const Vector3d point = randomPoint(random, 0.8);
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : body.triangles()) {
      const Vector3d on = closestPointOnTriangle(point, triangle[0], triangle[1], triangle[2]);
      least = std::min(least, (on - point).norm());
    }
    const auto start = static_cast<std::uint32_t>(random() % (2 * body.triangles().size()));
    const PointOnMesh found = nearest(body, point, start);
    ASSERT_NEAR(found.distance, least, kExact);
    ASSERT_NEAR((found.point - point).norm(), least, kExact);
    const double cutoff = uniform(random, 0.0, 1.0);
    const double rough = nearest(body, point, start, {cutoff}).distance;
    ASSERT_GE(rough, least - kExact);
    ASSERT_TRUE(rough <= cutoff || rough <= least + kExact);
    const double limit = uniform(random, 0.0, 1.0);
    const PointOnMesh within = nearest(body, point, start, {0.0, limit});
    ASSERT_EQ(within.triangle != kNone, least < limit);
    ASSERT_TRUE(within.triangle == kNone || std::abs(within.distance - least) <= kExact);
  }
}

}  // namespace
}  // namespace collision_monitor::test
