// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// Balls of radius 0.1 m in a row along x; limits 0 / 0.05 / 0.005 / 0.2 m, 0 / 0.1 / 0.05 s;
/// horizon 0.5 s, stop at 0.01 m in 0.25 s.
class LookAheadTest : public testing::Test {
 protected:
  /// The second ball `gap` from the first, coming nearer at `closing`.
  void runWithGap(double gap, double closing) {
    poses_.world_from_link[1].translation.x() = 0.2 + gap;
    setVelocity(0, 0.0);
    setVelocity(1, -closing);
    poses_.stamp_ns += 10'000'000;
    runCycle(setup_, poses_, buffers_);
  }
  void setVelocity(std::size_t link, double along_x) {
    poses_.velocities.of_link[link] = {Vector3d(along_x, 0, 0), Vector3d::Zero()};
    poses_.velocities.known[link] = 1;
  }
  const PairDistance& nearest() const {
    return buffers_.distances.pairs[buffers_.events.closest[0]];
  }
  Verdict verdict() const { return buffers_.events.verdicts[0]; }
  double scale() const { return buffers_.memory.speed.scale; }

  CycleSetup setup_ = test::handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = test::knownPoses(setup_);
};

/// Three such balls, all at rest.
class LookAheadOfThreeTest : public LookAheadTest {
 protected:
  LookAheadOfThreeTest() {
    setup_ = test::handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
    buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
    poses_ = test::knownPoses(setup_);
    poses_.velocities.known = {1, 1, 1};
  }
};

TEST_F(LookAheadTest, closingPair_hasSpeedAndTime) {
  runWithGap(0.06, 0.2);
  EXPECT_NEAR(nearest().closing_speed, 0.2, 1e-12);
  EXPECT_NEAR(nearest().time_to_contact, 0.3, 1e-12);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.3, 1e-12);
  EXPECT_EQ(buffers_.events.soonest[0], 0U);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(LookAheadTest, partingPair_neverMeets) {
  runWithGap(0.06, -0.2);
  EXPECT_NEAR(nearest().closing_speed, -0.2, 1e-12);
  EXPECT_EQ(nearest().time_to_contact, kInfinity);
  EXPECT_EQ(buffers_.events.time_to_contact, kInfinity);
  EXPECT_EQ(buffers_.events.soonest[0], kNone);
}

TEST_F(LookAheadTest, warningByTime_andItsHysteresis) {
  runWithGap(0.15, 1.0);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.099, 1.0);
  EXPECT_EQ(verdict(), Verdict::warning) << "0.099 s at 0.099 m";
  runWithGap(0.149, 1.0);
  EXPECT_EQ(verdict(), Verdict::warning);
  runWithGap(0.151, 1.0);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(LookAheadTest, contactByTime_onlyWhereAsked) {
  runWithGap(0.06, 2.0);
  EXPECT_EQ(verdict(), Verdict::warning) << "0.03 s, but contact_time is 0";
  setup_.limits.contact_time = 0.04;
  runWithGap(0.06, 2.0);
  EXPECT_EQ(verdict(), Verdict::contact);
  runWithGap(0.06, -2.0);
  EXPECT_EQ(verdict(), Verdict::clear) << "what parts is judged by its distance alone";
}

TEST_F(LookAheadTest, fastPairBeyondTheReach_isFoundWithinTheHorizon) {
  runWithGap(0.9, 2.0);
  ASSERT_NE(buffers_.events.closest[0], kNone);
  EXPECT_NEAR(nearest().time_to_contact, 0.45, 1e-12);
}

TEST_F(LookAheadTest, growBounds_whatAllShareCountsForNothing) {
  poses_.world_from_link[1].translation.x() = 0.9;
  setVelocity(0, 3.0);
  setVelocity(1, 3.0);
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(buffers_.counters.candidates, 0U);
  setVelocity(1, 1.0);
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(buffers_.counters.candidates, 1U);
}

TEST_F(LookAheadTest, velocityNotKnown_leavesVerdictsToTheDistance) {
  runWithGap(0.06, 5.0);
  poses_.velocities.known[1] = 0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(nearest().closing_speed));
  EXPECT_TRUE(std::isnan(nearest().time_to_contact));
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact));
  poses_.velocities.known[1] = 1;
  poses_.velocities.of_link[1].linear.x() = std::numeric_limits<double>::quiet_NaN();
  resetMemory(buffers_);
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(nearest().closing_speed));
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(LookAheadTest, overlappingPair_isInContactNow) {
  runWithGap(-0.02, -0.3);
  EXPECT_EQ(nearest().time_to_contact, 0.0);
  EXPECT_NEAR(nearest().closing_speed, -0.3, 1e-12);
}

TEST_F(LookAheadTest, scale_slowsWhatClosesAndFreesWhatParts) {
  runWithGap(0.15, 0.2);
  EXPECT_EQ(scale(), 1.0) << "0.14 m at 0.2 m/s take longer than 0.25 s";
  runWithGap(0.03, 0.2);
  EXPECT_NEAR(scale(), 0.4, 1e-12);
  runWithGap(0.009, 0.2);
  EXPECT_EQ(scale(), 0.0);
  runWithGap(0.009, 0.0);
  EXPECT_EQ(scale(), 0.0) << "stopped, and rests";
  runWithGap(0.009, -0.01);
  EXPECT_EQ(scale(), 1.0) << "moving away is free";
  runWithGap(0.009, 0.0);
  EXPECT_EQ(scale(), 1.0) << "it was not stopped since it parted";
}

TEST_F(LookAheadTest, scale_growsSlowlyWhileSomethingCloses) {
  runWithGap(0.03, 0.8);
  EXPECT_NEAR(scale(), 0.1, 1e-12);
  runWithGap(0.03, 0.1);
  EXPECT_NEAR(scale(), 0.12, 1e-12) << "10 ms of the 0.5 s";
}

/// A controller that multiplies a speed of 1 m/s by the scale of three cycles ago.
TEST_F(LookAheadTest, scale_inAClosedLoop_stopsAtTheStopDistanceWithoutChattering) {
  double gap = 0.5;
  double scales[] = {1.0, 1.0, 1.0, 1.0};
  int rises = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const double speed = scales[3];
    gap -= 0.01 * speed;
    runWithGap(gap, speed);
    std::copy_backward(scales, scales + 3, scales + 4);
    scales[0] = scale();
    ASSERT_LE(scales[0], scales[1] + 0.02 + 1e-12);
    rises += scales[0] > scales[1] ? 1 : 0;
  }
  EXPECT_EQ(scale(), 0.0);
  EXPECT_LT(gap, 0.01);
  EXPECT_GT(gap, 0.007);
  EXPECT_LT(rises, 100);
}

TEST_F(LookAheadTest, scale_ofWhatTouchesAndRests_isThatOfCreeping) {
  runWithGap(-0.01, 0.0);
  EXPECT_EQ(scale(), 0.0);
  setup_.ahead.stop.creep_scale = 0.05;
  runWithGap(-0.01, 0.0);
  EXPECT_NEAR(scale(), 0.02, 1e-12) << "slowly here, too";
  runWithGap(-0.01, 0.1);
  EXPECT_EQ(scale(), 0.0);
}

TEST_F(LookAheadTest, scale_withoutVelocities_goesByDistance) {
  runWithGap(0.03, 0.0);
  poses_.velocities.known[0] = 0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(scale(), 0.5, 1e-12) << "half way from warning_distance to stop_distance";
}

TEST_F(LookAheadTest, scale_whileALinkIsUnknown_isZero) {
  poses_.status[1] = LinkStatus::stale;
  runWithGap(1.0, -1.0);
  EXPECT_EQ(scale(), 0.0);
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact));
  poses_.status[1] = LinkStatus::known;
  runWithGap(1.0, -1.0);
  EXPECT_EQ(scale(), 1.0);
}

/// The nearest pair parts while another one closes: the derivative of the least distance would
/// say that all is well.
TEST_F(LookAheadOfThreeTest, scaleLooksAtEveryPair) {
  poses_.world_from_link[1].translation.x() = 0.22;   // 20 mm, parts
  poses_.world_from_link[2].translation.x() = -0.23;  // 30 mm, closes at 0.2 m/s
  poses_.velocities.of_link[1].linear.x() = 0.5;
  poses_.velocities.of_link[2].linear.x() = 0.2;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(buffers_.memory.speed.scale, 0.4, 1e-12);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.15, 1e-12);
}

/// A ball that rests beside another, and a third, 5 m off, nobody knows how fast.
TEST_F(LookAheadOfThreeTest, velocityOfAFarLinkNotKnown_noTimeIsKnown) {
  poses_.world_from_link[1].translation.x() = 0.3;
  poses_.world_from_link[2].translation.x() = 5.0;
  poses_.velocities.known = {1, 1, 0};
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact)) << "0.5 s are enough at 20 m/s";
  poses_.velocities.known = {1, 1, 1};
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(buffers_.events.time_to_contact, kInfinity);
}

TEST_F(LookAheadOfThreeTest, velocityOfTheRootNotFinite_othersAreSeenToClose) {
  poses_.world_from_link[0].translation.y() = 0.5;
  poses_.world_from_link[2].translation.x() = 1.2;
  poses_.velocities.of_link[0].linear.x() = std::numeric_limits<double>::quiet_NaN();
  poses_.velocities.of_link[2].linear.x() = -10.0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.1, 1e-12);
}

TEST(LookAhead, badNumbers_areAllNamed) {
  SetupReport report;
  Limits limits;
  limits.contact_time = 0.3;
  limits.time_hysteresis = -1.0;
  checkLimits(limits, "limits/", report);
  ASSERT_EQ(report.errors.size(), 2U);
  EXPECT_EQ(report.errors[0].where, "limits/warning_time");
  EXPECT_EQ(report.errors[0].accepted, "a finite number >= 0.3 s");
  EXPECT_EQ(report.errors[1].where, "limits/time_hysteresis");
}

}  // namespace
}  // namespace collision_monitor
