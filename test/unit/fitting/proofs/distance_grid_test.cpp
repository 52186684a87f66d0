// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/distance_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_monitor/geometry/triangle_bvh.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

TEST(DistanceGrid, outsideABox_isTheDistanceToIt) {
  const DistanceGrid grid(test::boxMesh({0.2, 0.1, 0.1}));
  EXPECT_NEAR(grid.distanceTo({0.24, 0.0, 0.0}), 0.04, grid.spacing());
  EXPECT_NEAR(grid.distanceTo({0.23, 0.14, 0.0}), 0.05, grid.spacing());
  // Farther than the grid reaches.
  EXPECT_NEAR(grid.distanceTo({2.2, 0.0, 0.0}), 2.0, grid.spacing());
}

TEST(DistanceGrid, insideAClosedMesh_isZero) {
  const DistanceGrid grid(test::boxMesh({0.2, 0.1, 0.1}));
  EXPECT_EQ(grid.distanceTo({0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(grid.distanceTo({0.15, 0.05, -0.05}), 0.0);
}

TEST(DistanceGrid, meshWithoutASide_hasNoInside) {
  TriangleMesh open = test::boxMesh({0.1, 0.1, 0.1});
  open.triangles.resize(10);
  const DistanceGrid grid(open);
  EXPECT_NEAR(grid.distanceTo({0.0, 0.0, 0.0}), 0.1, grid.spacing());
}

TEST(DistanceGrid, roundMesh_agreesWithTheMeshEverywhere) {
  const TriangleMesh mesh = test::moved(test::prismMesh(0.05, 0.3, 24), {0.3, 1.0, 0.2}, {1, 2, 3});
  const DistanceGrid grid(mesh);
  const TriangleBvh bvh(mesh);
  for (const auto& corner : test::randomCloud({0.3, 0.3, 0.3}, 500, 3).vertices) {
    const Vector3d point = corner + Vector3d(1, 2, 3);
    const double measured = bvh.nearestTo(point).distance;
    const double found = grid.distanceTo(point);
    if (found > 0.0 && measured < 0.08) {
      EXPECT_NEAR(found, measured, 1.5 * grid.spacing());
    }
    EXPECT_GT(found + 1.5 * grid.spacing(), found > 0.0 ? measured : 0.0);
  }
}

TEST(DistanceGrid, surfacePoints_lieOnTheSurfaceAndLeaveNoGap) {
  const TriangleMesh mesh = test::boxMesh({0.2, 0.1, 0.1});
  const DistanceGrid grid(mesh);
  const TriangleBvh bvh(mesh);
  const Points surface = grid.surface();
  for (const auto& point : surface) {
    EXPECT_LT(bvh.nearestTo(point).distance, 1e-12);
  }
  double nearest = 1.0;
  for (const auto& point : surface) {
    nearest = std::min(nearest, (point - Vector3d(0.2, 0.03, -0.02)).norm());
  }
  EXPECT_LT(nearest, 1.5 * grid.spacing());
}

TEST(DistanceGrid, onePoint_isThatPoint) {
  const DistanceGrid grid(TriangleMesh{{{1, 2, 3}}, {}});
  EXPECT_NEAR(grid.distanceTo({1, 2, 5}), 2.0, 1e-12);
}

}  // namespace
}  // namespace collision_monitor
