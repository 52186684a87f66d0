// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/run_cycle.h"

#include <gtest/gtest.h>

#include <limits>

#include "two_balls.h"

namespace collision_monitor::test {
namespace {

class RunCycle : public TwoBalls {};

class RunCycleOfThree : public ThreeBalls {};

TEST_F(RunCycle, apart_distancePointsAndNormalAreThoseOfTheSurfaces) {
  runWithGap(0.1);
  ASSERT_EQ(buffers_.distances.pairs.size(), 1U);
  const PairDistance& pair = buffers_.distances.pairs[0];
  EXPECT_EQ(pair.quality, Quality::exact);
  EXPECT_NEAR(pair.measured.distance, 0.1, 1e-15);
  EXPECT_TRUE(pair.measured.point_on_a.isApprox(Eigen::Vector3d(0.1, 0, 0), 1e-12));
  EXPECT_TRUE(pair.measured.point_on_b.isApprox(Eigen::Vector3d(0.2, 0, 0), 1e-12));
  EXPECT_TRUE(pair.measured.normal_a_to_b.isApprox(Eigen::Vector3d::UnitX(), 1e-12));
  EXPECT_EQ(verdict(), Verdict::clear);
  EXPECT_EQ(buffers_.events.overall, Verdict::clear);
}

TEST_F(RunCycle, missingLink_pairIsUnknownAndNeverClear) {
  poses_.status[1] = LinkStatus::missing;
  runWithGap(1.0);
  EXPECT_EQ(verdict(), Verdict::unknown);
  EXPECT_EQ(buffers_.events.overall, Verdict::unknown);
  EXPECT_EQ(buffers_.events.closest_of_all, kNone);
  EXPECT_EQ(buffers_.counters.unknown_links, 1U);
  EXPECT_EQ(buffers_.counters.unknown_pairs, 1U);
  EXPECT_TRUE(buffers_.events.changes.empty()) << "a clear pair falls silent with its link";
}

TEST_F(RunCycle, fastPairBeyondTheReach_isFoundWithinTheHorizon) {
  runWithGap(0.9, 2.0);
  ASSERT_NE(buffers_.events.closest[0], kNone);
  EXPECT_NEAR(nearest().time_to_contact, 0.45, 1e-12);
}

TEST_F(RunCycleOfThree, velocityOfTheRootNotFinite_othersAreSeenToClose) {
  poses_.world_from_link[0].translation.y() = 0.5;
  poses_.world_from_link[2].translation.x() = 1.2;
  poses_.velocities.of_link[0].linear.x() = std::numeric_limits<double>::quiet_NaN();
  poses_.velocities.of_link[2].linear.x() = -10.0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.1, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
