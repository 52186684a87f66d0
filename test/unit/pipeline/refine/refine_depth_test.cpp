// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

// The depth of overlapping meshes from cycle to cycle.
namespace collision_monitor {
namespace {

/// Two angles that cross: the inner corner of the second, where its edges meet, is in the first.
class RefineDepth : public testing::Test {
 protected:
  RefineDepth() {
    setup_ = test::geometrySetup({test::angleMesh(), test::angleMesh()}, SetupOptions());
    buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
    poses_ = test::knownPoses(setup_);
  }

  const PairDistance& runAt(const Eigen::Vector3d& second) {
    poses_.world_from_link[1].translation = second;
    runCycle(setup_, poses_, buffers_);
    return buffers_.distances.pairs.at(buffers_.events.closest_of_all);
  }
  const PairDistance& standAt(const Eigen::Vector3d& second) {
    for (int cycle = 0; cycle < 100; ++cycle) {
      runAt(second);
    }
    return runAt(second);
  }

  CycleSetup setup_;
  CycleBuffers buffers_;
  LinkPoses poses_;
};

// Its corner (0, 0, -0.05) is half way up the bar of the first along x, 0.03 m within its outer
// side; so is the corner (0.3, 0.1, 0.05) of the first in it.
const Eigen::Vector3d kInside(0.15, 0.03, 0.05);

TEST_F(RefineDepth, firstCycleAndStanding_theSameDepth) {
  const PairDistance first = runAt(kInside);
  EXPECT_EQ(first.quality, Quality::estimate);
  EXPECT_NEAR(first.measured.distance, -0.03, 1e-12);
  EXPECT_EQ(standAt(kInside).measured.distance, first.measured.distance);
}

TEST_F(RefineDepth, stands_noStepIsSpent) {
  standAt(kInside);
  EXPECT_EQ(buffers_.counters.refine_work, 0U);
  EXPECT_EQ(buffers_.counters.refined, 1U);
}

TEST_F(RefineDepth, slides_depthFollowsForLessThanTheFirstTime) {
  runAt(kInside);
  const std::size_t first_steps = buffers_.counters.refine_work;
  for (int step = 1; step < 10; ++step) {
    const double y = 0.03 - 0.001 * step;
    const PairDistance& found = runAt({0.15, y, 0.05});
    ASSERT_EQ(found.quality, Quality::estimate);
    ASSERT_NEAR(found.measured.distance, -y, 1e-12) << "less by its way";
    ASSERT_LT(buffers_.counters.refine_work, first_steps);
  }
}

TEST_F(RefineDepth, apartForACycle_nothingOldIsTold) {
  standAt(kInside);
  const PairDistance& apart = runAt({0.33, 0.0, 0.05});
  EXPECT_EQ(apart.quality, Quality::exact);
  EXPECT_NEAR(apart.measured.distance, 0.03, 1e-12);
  EXPECT_NEAR(runAt({0.15, 0.01, 0.05}).measured.distance, -0.01, 1e-12);
}

TEST_F(RefineDepth, poseNotFiniteForACycle_isUnknownAndThenAsBefore) {
  const double before = standAt(kInside).measured.distance;
  poses_.world_from_link[1].translation.x() = std::numeric_limits<double>::quiet_NaN();
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(buffers_.events.verdicts.at(0), Verdict::unknown);
  EXPECT_EQ(runAt(kInside).measured.distance, before);
}

TEST_F(RefineDepth, budgetSpentBeforeItsTurn_overlapIsCertainAndNoDepthIsTold) {
  // The least budget that proves the overlap.
  Quality quality = Quality::unknown;
  constexpr std::uint32_t kEnough = 1000;
  std::uint32_t budget = 0;
  for (; quality != Quality::estimate && budget < kEnough; ++budget) {
    resetMemory(buffers_);
    buffers_.refine.limits.budget = budget;
    quality = runAt(kInside).quality;
    ASSERT_EQ(buffers_.events.verdicts.at(0), Verdict::contact) << budget;
  }
  EXPECT_LT(budget, kEnough);
  EXPECT_EQ(buffers_.distances.pairs.at(buffers_.events.closest_of_all).measured.distance, 0.0)
      << "at least: the depth is 0.03";
}

TEST_F(RefineDepth, memoryReset_isSearchedAnew) {
  standAt(kInside);
  resetMemory(buffers_);
  EXPECT_NEAR(runAt(kInside).measured.distance, -0.03, 1e-12);
  EXPECT_GT(buffers_.counters.refine_work, 0U);
}

}  // namespace
}  // namespace collision_monitor
