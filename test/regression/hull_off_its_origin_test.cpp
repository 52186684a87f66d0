// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Hulls beside a mesh were called overlapping, and hulls within it clear.
// Where a search ended without a triangle, the origin of the hull's frame was asked for the inside.
// Now a corner of the hull is asked: the origin need not be in it.
#include <gtest/gtest.h>

#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "support/expect_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

TEST(HullOffItsOrigin, besideItsOriginBeyondTheLimit_isWhereItsCornersAre) {
  const MeshTree cube(boxMesh({1, 1, 1}), true);
  const auto memory = std::make_unique<MeshQueryMemory>();
  const auto distanceTo = [&](const Eigen::Vector3d& middle, const Pose& pose,
                              MeshQueryLimits limits) {
    const ConvexGeometry hull = ConvexHull(boxMeshAt({0.1, 0.1, 0.1}, middle).vertices);
    return distanceBetween({cube, at(0, 0, 0)}, PlacedConvex{hull, pose}, *memory, {}, limits);
  };
  MeshQueryLimits near_only;
  near_only.stop_beyond = 0.01;
  MeshQueryLimits no_budget;
  no_budget.visit_budget = 0;
  for (const MeshQueryLimits& limits : {near_only, no_budget}) {
    EXPECT_EQ(distanceTo({5, 0, 0}, at(0, 0, 0), limits).state, MeshState::lower_bound);
    EXPECT_EQ(distanceTo({5, 0, 0}, at(-5, 0, 0), limits).state, MeshState::overlapping);
  }
  EXPECT_NEAR(distanceTo({5, 0, 0}, at(-5, 0, 0), near_only).measured.distance, -0.9, kExact);
}

}  // namespace
}  // namespace collision_monitor::test
