// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "refine_scene.h"

// What a cycle refines when the budget does not suffice.
namespace collision_monitor {
namespace {

using test::hookedAngles;
using Scene = test::RefineScene;

TEST(RefineBudget, noBudget_lowerBoundsStay) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact) << "what is not refined is not clear";
  EXPECT_EQ(scene.closest().quality, Quality::lower_bound);
  EXPECT_EQ(scene.buffers.counters.left, 1U);
}

TEST(RefineBudget, posesThatComeSeldom_fourTimesAsMuchAtMost) {
  RefineWork work;
  work.limits.budget = 1000;
  for (const double elapsed : {0.0, 0.001, 0.004}) {
    work.elapsed = elapsed;
    EXPECT_EQ(budgetOf(work), 1000U) << elapsed;
  }
  work.elapsed = 0.008;
  EXPECT_EQ(budgetOf(work), 2000U);
  for (const double elapsed : {0.016, 0.02, 1e9}) {
    work.elapsed = elapsed;
    EXPECT_EQ(budgetOf(work), 4000U) << elapsed;
  }
  work.limits.period = 0.008;
  EXPECT_EQ(budgetOf(work), 2000U) << "cycles come more often than poses";
  work.limits.period = 1.0;
  work.limits.budget = 4'000'000'000U;
  EXPECT_EQ(budgetOf(work), 4'294'967'295U);
}

TEST(RefineBudget, stepBetweenStamps_isWhatPosesComeBy) {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.poses.stamp_ns = 1'000'000'000;
  scene.run();
  EXPECT_EQ(scene.buffers.refine.elapsed, 0.0) << "nothing came before";
  scene.poses.stamp_ns += 20'000'000;
  scene.run();
  EXPECT_EQ(scene.buffers.refine.elapsed, 0.02);
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

TEST(RefineBudget, budgetSpentAndNothingMoved_whatWasMeasuredStands) {
  Scene scene = twoHookedPairsWithoutBudget();
  const std::vector<PairDistance> before = scene.buffers.distances.pairs;
  scene.run();
  ASSERT_EQ(scene.buffers.distances.pairs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PairDistance& now = scene.buffers.distances.pairs[i];
    EXPECT_EQ(now.quality, Quality::exact);
    EXPECT_TRUE(now.is_refined);
    EXPECT_EQ(now.measured.distance, before.at(i).measured.distance);
    EXPECT_EQ(now.measured.point_on_b, before.at(i).measured.point_on_b);
  }
  EXPECT_EQ(scene.buffers.counters.left, 0U);
  EXPECT_EQ(scene.buffers.counters.refine_work, 0U);
}

TEST(RefineBudget, budgetSpentAndOneMoved_lessByItsWayAndABound) {
  Scene scene = twoHookedPairsWithoutBudget();
  scene.poses.world_from_link[3].translation.z() += 0.003;
  scene.run();
  EXPECT_EQ(scene.buffers.events.overall, Verdict::clear);
  EXPECT_EQ(scene.buffers.counters.left, 1U);
  ASSERT_EQ(scene.buffers.distances.pairs.size(), 2U);
  const PairDistance& moved = scene.buffers.distances.pairs[1];
  EXPECT_EQ(moved.quality, Quality::lower_bound);
  EXPECT_FALSE(moved.is_refined);
  EXPECT_NEAR(moved.measured.distance, 0.017, 1e-9);
}

TEST(RefineBudget, budgetSpentAndOneMovedFar_theEnclosingShapesSpeak) {
  Scene scene = twoHookedPairsWithoutBudget();
  scene.poses.world_from_link[3].translation.z() += 0.03;
  scene.run();
  EXPECT_EQ(scene.buffers.events.overall, Verdict::contact);
}

TEST(RefineBudget, pairThatMayTouch_isMeasuredBeforeOneThatWaits) {
  Scene scene = twoHookedPairsWithoutBudget();
  scene.buffers.refine.limits.budget = 100000;
  Pose& nearer = scene.poses.world_from_link[3];
  const double normal_y = scene.closest().measured.normal_a_to_b.y();
  nearer.translation.y() -= 0.0185 * normal_y;
  scene.run();
  ASSERT_NEAR(scene.closest().measured.distance, 0.0015, 1e-9);
  nearer.translation.z() +=
      0.0016;  // beside the other: the last distance does not prove them apart
  scene.poses.world_from_link[1].translation.z() += 0.005;
  scene.buffers.memory.starved_cycles[scene.setup.element_pair_of[0]] = 9;
  scene.buffers.refine.limits.budget = 100;
  scene.run();
  EXPECT_NEAR(scene.closest().measured.distance, 0.0015, 1e-6);
  EXPECT_EQ(scene.buffers.events.overall, Verdict::warning);
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

TEST(RefineBudget, budgetOfOneSearch_thoseThatWaitedComeFirst) {
  Scene scene = threeCylinders();
  std::vector<std::uint32_t> refined;
  for (int cycle = 0; cycle < 6; ++cycle) {
    for (Pose& pose : scene.poses.world_from_link) {
      pose.translation.z() += 1e-6;
    }
    scene.run();
    ASSERT_EQ(scene.buffers.counters.refined, 1U);
    ASSERT_EQ(scene.buffers.counters.left, 2U);
    for (const PairDistance& pair : scene.buffers.distances.pairs) {
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

TEST(RefineBudget, budgetOfOneSearchAtRest_isSpentOnWhatIsNotKnownYet) {
  Scene scene = threeCylinders();
  for (std::size_t cycle = 0; cycle < 5; ++cycle) {
    scene.run();
    EXPECT_EQ(scene.buffers.counters.refined, std::min<std::size_t>(cycle + 1, 3));
  }
  EXPECT_EQ(scene.buffers.counters.refine_work, 0U);
}

}  // namespace
}  // namespace collision_monitor
