// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/refine_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "refine_scene.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::hookedAngles;
using test::optionsFor;
using Scene = test::RefineScene;

TEST(RefinePairs, hookedAngles_enclosingShapesSeeAContact) {
  Scene scene = hookedAngles(RefineGeometry::none);
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_EQ(scene.closest().quality, Quality::lower_bound);
  EXPECT_EQ(scene.buffers.counters.refined + scene.buffers.counters.left, 0U);
}

TEST(RefinePairs, hookedAngles_hullsSeeAContact) {
  Scene scene = hookedAngles(RefineGeometry::hull);
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_EQ(scene.closest().quality, Quality::lower_bound)
      << "the hulls overlap, the angles do not";
}

TEST(RefinePairs, hookedAngles_meshesAreClearByTheirExactDistance) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
  EXPECT_EQ(scene.closest().quality, Quality::exact);
  EXPECT_TRUE(scene.closest().is_refined);
  EXPECT_NEAR(scene.closest().measured.distance, 0.02, 1e-12);
  EXPECT_NEAR(std::abs(scene.closest().measured.normal_a_to_b.y()), 1.0, 1e-9);
  EXPECT_EQ(scene.buffers.counters.refined, 1U);
  EXPECT_EQ(scene.buffers.counters.left, 0U);
}

TEST(RefinePairs, severalShapesPerLink_pairOfElementsKeepsOneEntry) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.default_limits.max_shapes = 2;
  Scene scene({test::angleMesh(), test::angleMesh()}, options);
  scene.poses.world_from_link[1] = test::hookedPose();
  ASSERT_EQ(scene.setup.table.size(), 4U);
  scene.run();
  ASSERT_EQ(scene.buffers.distances.pairs.size(), 1U);
  EXPECT_NEAR(scene.closest().measured.distance, 0.02, 1e-12);
}

TEST(RefinePairs, anglesCross_overlapIsCertainAndItsDepthAnEstimate) {
  Scene scene({test::angleMesh(), test::angleMesh()});
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.15, -0.02, 0.03);
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_EQ(scene.closest().quality, Quality::estimate);
  // The inner corner of the second lies 0.02 m in the first; along z, 0.07 m separate them.
  EXPECT_LE(scene.closest().measured.distance, -0.02 + 1e-9);
  EXPECT_GE(scene.closest().measured.distance, -0.07 - 1e-9);
}

TEST(RefinePairs, depthThatLimitsAllow_isAContactWhileItIsAnEstimate) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.limits.contact_distance = -10.0;
  Scene scene({test::angleMesh(), test::angleMesh()}, options);
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
}

TEST(RefinePairs, depthThatLimitsAllow_hidesNoEstimateOfAnotherElement) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.limits.contact_distance = -0.3;
  Pose above;
  above.translation.z() = 1.0;
  const std::vector<CollisionElement> link = {{"angle", Pose(), test::angleMesh()},
                                              {"box", above, Box{{0.2, 0.2, 0.2}}}};
  Scene scene(test::linkSetup({link, link}, options));
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.15, -0.02, 0.03);
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::estimate) << "the angles overlap, too";
  EXPECT_NEAR(scene.closest().measured.distance, -0.25, 1e-9);
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  LinkPairMeasures measures(scene.setup);
  const PairDistance distance = elementDistance(measures, 0, scene.poses.world_from_link);
  EXPECT_EQ(distance.quality, Quality::estimate) << "0.25 m deep, perhaps deeper";
  EXPECT_NEAR(distance.measured.distance, -0.25, 1e-9);
}

TEST(RefinePairs, distanceBeyondEnough_isABoundAndNoMore) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  const auto distance = [&](double cutoff) {
    LinkPairMeasures measures(scene.setup);
    return elementDistance(measures, 0, scene.poses.world_from_link, cutoff);
  };
  const PairDistance whole = distance(1.0);
  EXPECT_EQ(whole.quality, Quality::exact);
  const double apart = whole.measured.distance;
  EXPECT_GT(apart, 0.0);
  EXPECT_EQ(distance(1.01 * apart).measured.distance, apart);
  const PairDistance bound = distance(0.5 * apart);
  EXPECT_EQ(bound.quality, Quality::lower_bound);
  EXPECT_GE(bound.measured.distance, 0.5 * apart);
  EXPECT_LE(bound.measured.distance, apart);
}

TEST(RefinePairs, smallBallDeepInABar_leavesThroughTheNearestFace) {
  for (const bool is_long_x : {true, false}) {
    Scene scene({test::angleMesh(), Sphere{0.005}});
    const Eigen::Vector3d place(0.23, 0.04, 0.005);
    scene.poses.world_from_link[1].translation =
        is_long_x ? place : Eigen::Vector3d(place.y(), place.x(), place.z());
    scene.run();
    EXPECT_EQ(scene.verdict(), Verdict::contact);
    EXPECT_NEAR(scene.closest().measured.distance, -0.045, 1e-9);
    const Eigen::Vector3d& normal = scene.closest().measured.normal_a_to_b;
    EXPECT_NEAR(is_long_x ? normal.y() : normal.x(), -1.0, 1e-9);
  }
}

TEST(RefinePairs, innerShapesOverlap_depthIsAtLeastTheirs) {
  Scene scene({test::angleMesh(), Sphere{0.05}});
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.05, 0.05, 0.0);
  ASSERT_TRUE(scene.setup.elements[0].inner.sphere && scene.setup.elements[1].inner.sphere);
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::estimate);
  EXPECT_LE(scene.closest().measured.distance, -0.09) << "the ball lies in the angle's corner";
}

TEST(RefinePairs, convexMesh_isMeasuredExactlyAlsoInDepth) {
  Scene scene({test::boxMesh({0.1, 0.1, 0.1}), Cylinder{0.1, 0.1}});
  ASSERT_TRUE(scene.setup.elements[0].convex.has_value());
  scene.moveTo(1, 0.23);
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::exact);
  EXPECT_NEAR(scene.closest().measured.distance, 0.03, 1e-9);
  scene.moveTo(1, 0.19);
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::exact);
  EXPECT_NEAR(scene.closest().measured.distance, -0.01, 1e-7);
}

TEST(RefinePairs, cylinderAndConcaveMesh_isMeasuredExactly) {
  Scene scene({test::angleMesh(), Cylinder{0.1, 0.05}});
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.17, 0.17, 0.0);
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::exact);
  EXPECT_NEAR(scene.closest().measured.distance, 0.02, 1e-9);
}

TEST(RefinePairs, padding_isTakenOffAndMakesALowerBound) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.padding = 0.004;
  Scene scene({test::angleMesh(), test::angleMesh()}, options);
  scene.poses.world_from_link[1] = test::hookedPose();
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::lower_bound);
  EXPECT_NEAR(scene.closest().measured.distance, 0.012, 1e-12);
}

TEST(RefinePairs, triangleOfOnePoint_isPartOfTheMesh_unusedVertexIsNot) {
  TriangleMesh mesh = test::angleMesh();
  const auto distanceTo = [](const TriangleMesh& to) {
    Scene scene({to, Sphere{0.01}});
    scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.33, 0.3, 0.0);
    scene.run();
    return scene.closest().measured.distance;
  };
  const auto point = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.3, 0.3, 0.0);
  EXPECT_GT(distanceTo(mesh), 0.1);
  mesh.triangles.push_back({point, point, point});
  EXPECT_NEAR(distanceTo(mesh), 0.02, 1e-9);
}

TEST(RefinePairs, nanPose_pairStaysUnknown) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.poses.world_from_link[0].translation.z() = std::numeric_limits<double>::quiet_NaN();
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::unknown);
  EXPECT_EQ(scene.buffers.counters.refined, 0U);
}

TEST(RefinePairs, refinedOutOfReach_theClosestIsStillFound) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.limits = {0.0, 0.01, 0.002, 0.015};
  options.refine.limits.distance = 0.012;
  Scene scene({test::angleMesh(), test::angleMesh(), Sphere{0.01}}, options);
  scene.poses.world_from_link[1] = test::hookedPose();
  scene.poses.world_from_link[2].translation = Eigen::Vector3d(-0.028, 0.05, 0.0);
  scene.run();
  EXPECT_NEAR(scene.closest().measured.distance, 0.018, 1e-6) << "the ball beside the first angle";
}

TEST(RefinePairs, resetMemory_changesNoDistance) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.run();
  const double before = scene.closest().measured.distance;
  scene.run();
  EXPECT_EQ(scene.closest().measured.distance, before);
  resetMemory(scene.buffers);
  scene.run();
  EXPECT_EQ(scene.closest().measured.distance, before);
}

}  // namespace
}  // namespace collision_monitor
