// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/near_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// Once a triangle has been nearest, nothing that is known may be passed over for it.
TEST(NearTriangles, knownNearest_isTheNearestOfAllThatWereMet) {
  for (const TriangleMesh& mesh : {sphereMesh(1.0, 12), prismMesh(0.2, 3.0, 7)}) {
    const TriangleBvh bvh(mesh);
    NearTriangles near(bvh);
    EXPECT_EQ(near.nearestKnown(Vector3d::Zero()).leaf_triangle, kNone);
    std::vector<std::uint32_t> met;
    for (int i = 0; i < 300; ++i) {
      const Vector3d point(std::sin(1.1 * i), std::cos(2.3 * i), 2.0 * std::sin(0.7 * i));
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::uint32_t triangle : met) {
        nearest = std::min(nearest, bvh.nearestOn(triangle, point).distance);
      }
      EXPECT_EQ(near.nearestKnown(point).distance, nearest);
      met.push_back(near.nearestOfAll(point, 0.1).leaf_triangle);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
