// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes 1e16 m apart were called touching, and a search of them crashed.
// Bounds of nodes are floats: they overflowed, and their NaN came out as a gap of 0.
// Now what is farther than 1e15 m is unknown, and no search opens a slot without a child.
#include <gtest/gtest.h>

#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "support/expect_distance.h"
#include "support/mesh_overlap.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

TEST(MeshesFarApart, poseBeyondAllReach_isUnknown) {
  const MeshTree cube(boxMesh({1, 1, 1}), true);
  const Shape ball = Sphere{0.1};
  const auto memory = std::make_unique<MeshQueryMemory>();
  const ConvexGeometry hull = ConvexHull(boxMesh({1, 1, 1}).vertices);
  const auto kept = std::make_unique<KeptDepth>();
  for (const double far : {1e16, 1e18, 1e39, 1e60, 1e308}) {
    for (const Pose& pose : {at(far, 0, 0), at(far, far, far), at(-far, far, 0)}) {
      EXPECT_EQ(distanceBetween({cube, at(0, 0, 0)}, {cube, pose}, *memory).state,
                MeshState::unknown)
          << far;
      EXPECT_EQ(distanceBetween({cube, pose}, {cube, at(0, 0, 0)}, *memory).state,
                MeshState::unknown)
          << far;
      EXPECT_EQ(distanceBetween({cube, at(0, 0, 0)}, {ball, pose}, *memory).state,
                MeshState::unknown)
          << far;
      EXPECT_EQ(distanceBetween({cube, at(0, 0, 0)}, PlacedConvex{hull, pose}, *memory).state,
                MeshState::unknown)
          << far;
      EXPECT_FALSE(meshesOverlap({cube, at(0, 0, 0)}, {cube, pose}, *memory)) << far;
      EXPECT_EQ(depthOf({cube, at(0, 0, 0)}, {cube, pose}, *memory, *kept, 60).deepest.distance,
                0.0);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
