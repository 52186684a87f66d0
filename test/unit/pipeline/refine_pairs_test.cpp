// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/refine_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision_monitor/pipeline/run_cycle.h"
#include "support/geometry_setup.h"
#include "support/hand_made_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

SetupOptions optionsFor(RefineGeometry geometry) {
  SetupOptions options;
  options.limits = {0.0, 0.01, 0.002, 0.2};
  options.refine.geometry = geometry;
  options.default_limits.max_shapes = 1;
  return options;
}

/// A set-up whose links stand at the origin, and its cycles.
struct Scene {
  explicit Scene(CycleSetup made)
      : setup(std::move(made)),
        buffers(makeBuffers(setup, BroadPhaseKind::brute_force)),
        poses(test::knownPoses(setup)) {}
  explicit Scene(const std::vector<Geometry>& geometries,
                 const SetupOptions& options = optionsFor(RefineGeometry::mesh))
      : Scene(test::geometrySetup(geometries, options)) {}

  void run() { runCycle(setup, poses, buffers); }
  void moveTo(std::size_t link, double x) { poses.world_from_link[link].translation.x() = x; }
  const PairDistance& closest() const {
    return buffers.distances.measured.at(buffers.events.closest_of_all);
  }
  Verdict verdict() const { return buffers.events.verdicts.at(0); }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
};

Scene hookedAngles(RefineGeometry geometry) {
  Scene scene({test::angleMesh(), test::angleMesh()}, optionsFor(geometry));
  scene.poses.world_from_link[1] = test::hookedPose();
  return scene;
}

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

/// Two pairs of hooked angles far from each other, measured once; then the budget is spent at once.
Scene twoHookedPairsWithoutBudget() {
  const auto angle = test::angleMesh();
  Scene scene({angle, angle, angle, angle});
  const Pose away{Eigen::Matrix3d::Identity(), {5.0, 0.0, 0.0}};
  scene.poses.world_from_link[1] = test::hookedPose();
  scene.poses.world_from_link[2] = away;
  scene.poses.world_from_link[3] = away * test::hookedPose();
  scene.run();
  scene.buffers.refine.limits.budget = 0;
  return scene;
}

TEST(RefinePairs, budgetSpentAndNothingMoved_whatWasMeasuredStands) {
  Scene scene = twoHookedPairsWithoutBudget();
  const std::vector<PairDistance> before = scene.buffers.distances.measured;
  scene.run();
  ASSERT_EQ(scene.buffers.distances.measured.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PairDistance& now = scene.buffers.distances.measured[i];
    EXPECT_EQ(now.quality, Quality::exact);
    EXPECT_TRUE(now.is_refined);
    EXPECT_EQ(now.measured.distance, before.at(i).measured.distance);
    EXPECT_EQ(now.measured.point_on_b, before.at(i).measured.point_on_b);
  }
  EXPECT_EQ(scene.buffers.counters.left, 0U);
  EXPECT_EQ(scene.buffers.counters.refine_steps, 0U);
}

TEST(RefinePairs, budgetSpentAndOneMoved_lessByItsWayAndABound) {
  Scene scene = twoHookedPairsWithoutBudget();
  scene.poses.world_from_link[3].translation.z() += 0.003;
  scene.run();
  EXPECT_EQ(scene.buffers.events.overall, Verdict::clear);
  EXPECT_EQ(scene.buffers.counters.left, 1U);
  ASSERT_EQ(scene.buffers.distances.measured.size(), 2U);
  const PairDistance& moved = scene.buffers.distances.measured[1];
  EXPECT_EQ(moved.quality, Quality::lower_bound);
  EXPECT_FALSE(moved.is_refined);
  EXPECT_NEAR(moved.measured.distance, 0.017, 1e-9);
}

TEST(RefinePairs, budgetSpentAndOneMovedFar_theEnclosingShapesSpeak) {
  Scene scene = twoHookedPairsWithoutBudget();
  scene.poses.world_from_link[3].translation.z() += 0.03;
  scene.run();
  EXPECT_EQ(scene.buffers.events.overall, Verdict::contact);
}

TEST(RefinePairs, severalShapesPerLink_pairOfElementsKeepsOneEntry) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.default_limits.max_shapes = 2;
  Scene scene({test::angleMesh(), test::angleMesh()}, options);
  scene.poses.world_from_link[1] = test::hookedPose();
  ASSERT_EQ(scene.setup.table.size(), 4U);
  scene.run();
  ASSERT_EQ(scene.buffers.distances.measured.size(), 1U);
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

TEST(RefinePairs, openMesh_surfaceCountsAndAWarningSaysSo) {
  TriangleMesh open = test::angleMesh();
  open.triangles.pop_back();
  const Scene scene({open, Sphere{0.01}});
  ASSERT_EQ(scene.setup.report.warnings.size(), 1U);
  EXPECT_NE(scene.setup.report.warnings[0].found.find("link_0"), std::string::npos);
}

TEST(RefinePairs, strayVertex_isPartOfTheMesh) {
  TriangleMesh mesh = test::angleMesh();
  mesh.vertices.emplace_back(0.3, 0.3, 0.0);
  Scene scene({mesh, Sphere{0.01}});
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.33, 0.3, 0.0);
  scene.run();
  EXPECT_NEAR(scene.closest().measured.distance, 0.02, 1e-9);
}

TEST(RefinePairs, nanPose_pairStaysUnknown) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.poses.world_from_link[0].translation.z() = std::numeric_limits<double>::quiet_NaN();
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::unknown);
  EXPECT_EQ(scene.buffers.counters.refined, 0U);
}

TEST(RefinePairs, noBudget_lowerBoundsStay) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact) << "what is not refined is not clear";
  EXPECT_EQ(scene.closest().quality, Quality::lower_bound);
  EXPECT_EQ(scene.buffers.counters.left, 1U);
}

/// A ball in a shell, twice, far from each other. Both surfaces have a hole and no inside: they are
/// apart, and everywhere by nearly the same distance, which takes long to find.
Scene ballsInShells() {
  TriangleMesh ball = test::sphereMesh(0.1, 24);
  TriangleMesh shell = test::sphereMesh(0.2, 24);
  ball.triangles.pop_back();
  shell.triangles.pop_back();
  Scene scene({ball, shell, ball, shell});
  scene.moveTo(2, 5.0);
  scene.moveTo(3, 5.0);
  return scene;
}

TEST(RefinePairs, budgetOfOneDistance_noContactOfEnclosingShapesIsLeft) {
  Scene scene = ballsInShells();
  scene.buffers.refine.limits.budget = 1000000;
  scene.run();
  ASSERT_EQ(scene.buffers.counters.left, 0U);
  ASSERT_GT(scene.closest().measured.distance, 0.09);
  resetMemory(scene.buffers);
  scene.buffers.refine.limits.budget =
      static_cast<std::uint32_t>(scene.buffers.counters.refine_steps / 2);
  scene.run();
  EXPECT_GT(scene.buffers.counters.left, 0U);
  EXPECT_NE(scene.buffers.events.overall, Verdict::contact);
  for (const PairDistance& pair : scene.buffers.distances.measured) {
    EXPECT_GE(pair.measured.distance, 0.002) << "as much as it takes to be in no contact";
  }
}

/// Three cylinders side by side, their enclosing boxes in reach of each other, and a budget that
/// one of them spends.
Scene threeCylinders() {
  Scene scene({Cylinder{0.1, 0.05}, Cylinder{0.1, 0.05}, Cylinder{0.1, 0.05}});
  scene.moveTo(1, 0.102);
  scene.poses.world_from_link[2].translation = Eigen::Vector3d(0.051, 0.09, 0.0);
  scene.buffers.refine.limits.budget = 1;
  return scene;
}

TEST(RefinePairs, budgetOfOneSearch_thoseThatWaitedComeFirst) {
  Scene scene = threeCylinders();
  std::vector<std::uint32_t> refined;
  for (int cycle = 0; cycle < 6; ++cycle) {
    for (Pose& pose : scene.poses.world_from_link) {
      pose.translation.z() += 1e-6;
    }
    scene.run();
    ASSERT_EQ(scene.buffers.counters.refined, 1U);
    ASSERT_EQ(scene.buffers.counters.left, 2U);
    for (const PairDistance& pair : scene.buffers.distances.measured) {
      if (pair.is_refined) {
        refined.push_back(scene.setup.link_pair_of[index(pair.pair)]);
      }
    }
  }
  ASSERT_EQ(refined.size(), 6U);
  EXPECT_NE(refined[0], refined[1]);
  EXPECT_NE(refined[1], refined[2]);
  EXPECT_NE(refined[0], refined[2]);
  EXPECT_EQ(refined[3], refined[0]);
}

TEST(RefinePairs, budgetOfOneSearchAtRest_isSpentOnWhatIsNotKnownYet) {
  Scene scene = threeCylinders();
  for (std::size_t cycle = 0; cycle < 5; ++cycle) {
    scene.run();
    EXPECT_EQ(scene.buffers.counters.refined, std::min<std::size_t>(cycle + 1, 3));
  }
  EXPECT_EQ(scene.buffers.counters.refine_steps, 0U);
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
