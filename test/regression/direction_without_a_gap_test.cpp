// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "support/own_front.h"
#include "support/pose_at.h"
#include "support/sample_meshes.h"

// A search that stops at 0 kept each pair with the direction it was asked along, also where the two
// overlap along it. The front then took the overlap for a gap of 0, and a motion out of the overlap
// for a distance: a hull 0.3 m from a mesh was told to be exactly 0.7 m away.
namespace collision_monitor::test {
namespace {

MeshDistance cold(const MeshTree& mesh, const PlacedConvex& hull, MeshQueryMemory& memory) {
  return distanceBetween({mesh, Pose()}, hull, memory);
}

TEST(DirectionWithoutAGap, hullBetweenTwoTrianglesAfterALimitOfZero) {
  const auto memory = std::make_unique<MeshQueryMemory>();
  const MeshTree mesh(
      TriangleMesh{{{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}, {-3, -3, -3}, {3, -3, -3}, {0, 3, -3}},
                   {{0, 1, 2}, {3, 4, 5}}});
  const ConvexGeometry hull = ConvexHull(boxMesh({1, 1, 1}).vertices);
  for (double z = -2.0; z < 0.0; z += 0.05) {
    OwnFront front;
    const auto follow = [&](double height, double stop_beyond) {
      MeshQueryLimits limits;
      limits.stop_beyond = stop_beyond;
      return distanceBetween({mesh, Pose()}, PlacedConvex{hull, at(0, 0, height)}, *memory, front,
                             limits);
    };
    follow(2.0, kInfinity);
    follow(0.0, 0.0);
    follow(z, 2.0);
    const MeshDistance found = follow(z + 1e-6, kInfinity);
    const MeshDistance truth = cold(mesh, {hull, at(0, 0, z + 1e-6)}, *memory);
    EXPECT_EQ(found.state, truth.state) << z;
    EXPECT_NEAR(found.measured.distance, truth.measured.distance, 1e-12) << z;
  }
}

}  // namespace
}  // namespace collision_monitor::test
