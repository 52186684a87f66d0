// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "geometry/hulls/convex_hull.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor::test {
namespace {

// Found by the stress program: two triangles all but equally near to a capsule that lies across
// their normals. The bound of the nearer one had no slack in that direction, came out a rounding
// too large, and the triangle was passed over: 3.4e-9 m too far.
TEST(MeshSlack, trianglesAllButEquallyNear_theNearerIsFoundInEveryOrder) {
  std::vector<Eigen::Vector3d> corners = {
      {-1.1775901505736779, 0.85556932495201377, -1.455581475743279},
      {0.44979941270203855, 1.3843402475041615, -1.455581475743279},
      {1.455581475743279, 0, -1.455581475743279},
      {0.44979941270203821, -1.3843402475041615, -1.455581475743279},
      {-1.1775901505736783, -0.85556932495201343, -1.455581475743279},
      {0.44979941270203855, 1.3843402475041615, 1.455581475743279},
      {1.455581475743279, 0, 1.455581475743279},
      {-1.1775901505736779, 0.85556932495201377, 1.455581475743279},
      {-1.1775901505736783, -0.85556932495201343, 1.455581475743279},
      {0.44979941270203821, -1.3843402475041615, 1.455581475743279}};
  Pose world_from_mesh;
  world_from_mesh.rotation << -0.53868982838882395, -0.81758199927371311, -0.20340340030102277,
      -0.8287494121598874, 0.47077311051012216, 0.30256749704035546, -0.15161688769744902,
      0.33156048148749995, -0.93117128740136579;
  world_from_mesh.translation << -4.2722279081142585, 2.9058147930849376, -0.70110514343114527;
  Pose world_from_capsule;
  world_from_capsule.rotation << -0.53868985435408667, 0.2034033585177151, -0.81758199256079955,
      -0.82874939549203808, -0.30256748352466167, 0.47077314853880026, -0.15161688655144853,
      0.93117130092011979, 0.33156044404478913;
  world_from_capsule.translation << -3.6365762728424533, 3.8837354652564957, -0.52219788080850338;
  const Shape capsule = Capsule{0.11580188432237645, 0.0018530234552019387};
  const auto memory = std::make_unique<MeshQueryMemory>();
  std::mt19937 random(20260101);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(corners.begin(), corners.end(), random);
    const MeshTree tree(convexHullOf(corners), true);
    const MeshDistance found = distanceBetween(PlacedMesh{tree, world_from_mesh},
                                               PlacedShape{capsule, world_from_capsule}, *memory);
    EXPECT_NEAR(found.measured.distance, 5.5243742625974e-4, 1e-14) << i;
  }
}

}  // namespace
}  // namespace collision_monitor::test
