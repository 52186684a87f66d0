// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Bodies in an open mesh met nothing: 85 % of an open cube was in none of its 16 shapes.
// Shapes lay along its surface as about a thin wall, and ways through a hole were not followed.
// Now one more shape fills the hollow, and what dips through a hole on its way is found.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pipeline/cycle/cycle_buffers.h"
#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"
#include "unit/pipeline/setup/open_torso.h"

namespace collision_monitor::test {
namespace {

using open_meshes::bin;
using open_meshes::forearm;

TEST(HollowOfOpenMesh, manyShapes_leaveNoHollowBetweenThem) {
  TriangleMesh open = boxMesh({0.3, 0.3, 0.3});
  open.triangles.pop_back();
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.default_limits.max_shapes = 16;
  RefineScene scene({open, Sphere{0.02}}, options);
  ASSERT_GT(scene.setup.bodies.size(), 10U);
  for (const double x : {-0.2, 0.0, 0.1}) {
    for (const double y : {-0.15, 0.05, 0.2}) {
      for (const double z : {-0.2, -0.1, 0.0, 0.1}) {
        scene.poses.world_from_link[1].translation = {x, y, z};
        scene.run();
        EXPECT_EQ(scene.buffers.events.overall, Verdict::contact) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(HollowOfOpenMesh, inAndOutBetweenTwoCycles_isAPassedContact) {
  for (const Geometry& geometry : {Geometry(forearm()), Geometry(Capsule{0.01, 0.01})}) {
    // 6 m wide: the sides are farther off than the arm comes.
    RefineScene scene({scaled(bin(), 15.0), geometry});
    scene.setup.is_continuous = true;
    scene.buffers = makeBuffers(scene.setup, BroadPhaseKind::brute_force);
    scene.poses.stamp_ns = 1'000'000'000;
    // On an arc of 2 m that dips 5 cm below the hole, from 4 cm above it and back.
    const Eigen::Vector3d axis(0.0, 0.0, 4.95);
    for (const double angle : {-0.3, 0.3}) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
      scene.poses.world_from_link[1] = {turn, axis + turn * Eigen::Vector3d(0, 0, -2.0)};
      scene.run();
      EXPECT_EQ(scene.buffers.distances.passed.empty(), angle < 0.0);
      scene.poses.stamp_ns += 20'000'000;
    }
    ASSERT_EQ(scene.buffers.distances.passed.size(), 1U) << geometry.index();
    EXPECT_GT(scene.buffers.distances.pairs.at(0).measured.distance, 0.01) << "now apart again";
    EXPECT_EQ(scene.verdict(), Verdict::contact);
  }
}

}  // namespace
}  // namespace collision_monitor::test
