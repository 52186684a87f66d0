// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/measure_fully.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "refine_scene.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

RefineScene paddedAngles() {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.padding = 0.001;
  RefineScene scene({angleMesh(), angleMesh()}, options);
  scene.poses.world_from_link[1] = hookedPose();
  scene.run();
  return scene;
}

bool measureFirst(RefineScene& scene) {
  CycleBuffers& buffers = scene.buffers;
  return measureFully(scene.setup, buffers.body_poses, buffers.memory, 0, buffers.refine,
                      buffers.distances);
}

// What was measured may be recalled as a bound, and measured again. Then rounding made the points
// seem nearer than the bound, and those of the enclosing shapes were kept.
TEST(MeasureFully, boundRaisedToTheDistance_pointsAreThoseOfTheGeometries) {
  RefineScene scene = paddedAngles();
  PairDistance& pair = scene.buffers.distances.pairs.at(0);
  ASSERT_TRUE(pair.is_refined);
  ASSERT_EQ(pair.quality, Quality::lower_bound) << "padded";
  const SignedDistance measured = pair.measured;
  pair.is_refined = false;
  pair.is_raised = true;
  pair.measured.distance =
      std::nextafter(measured.distance, std::numeric_limits<double>::infinity());
  pair.measured.normal_a_to_b = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(measureFirst(scene));
  EXPECT_TRUE(pair.is_refined);
  EXPECT_EQ(pair.measured.normal_a_to_b, measured.normal_a_to_b);
}

TEST(MeasureFully, shapesFartherApart_theirBoundStays) {
  RefineScene scene = paddedAngles();
  PairDistance& pair = scene.buffers.distances.pairs.at(0);
  const double bound = pair.measured.distance + 1e-3;
  pair.is_refined = false;
  pair.measured.distance = bound;
  EXPECT_TRUE(measureFirst(scene));
  EXPECT_FALSE(pair.is_refined);
  EXPECT_EQ(pair.measured.distance, bound);
}

}  // namespace
}  // namespace collision_monitor::test
