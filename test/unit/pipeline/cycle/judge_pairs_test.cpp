// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/judge_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "two_balls.h"

namespace collision_monitor::test {
namespace {

class JudgePairs : public TwoBalls {};

class JudgePairsOfThree : public ThreeBalls {};

TEST_F(JudgePairs, verdictFollowsTheDistance) {
  runWithGap(0.06);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.04);
  EXPECT_EQ(verdict(), Verdict::warning);
  runWithGap(-0.01);
  EXPECT_EQ(verdict(), Verdict::contact);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::warning);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::contact);
}

TEST_F(JudgePairs, verdictIsLeftOnlyBeyondTheHysteresis) {
  runWithGap(0.04);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::warning);
  EXPECT_TRUE(buffers_.events.changes.empty());
  runWithGap(0.056);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.0);
  runWithGap(0.004);
  EXPECT_EQ(verdict(), Verdict::contact);
  runWithGap(0.006);
  EXPECT_EQ(verdict(), Verdict::warning);
}

TEST_F(JudgePairs, nearPairThatBecomesUnknown_isReportedAndComesBack) {
  runWithGap(0.01);
  poses_.status[0] = LinkStatus::stale;
  runWithGap(0.01);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::unknown);
  poses_.status[0] = LinkStatus::known;
  runWithGap(1.0);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::unknown);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::clear);
}

TEST_F(JudgePairs, warningByTime_andItsHysteresis) {
  runWithGap(0.15, 1.0);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.099, 1.0);
  EXPECT_EQ(verdict(), Verdict::warning) << "0.099 s at 0.099 m";
  runWithGap(0.149, 1.0);
  EXPECT_EQ(verdict(), Verdict::warning);
  runWithGap(0.151, 1.0);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(JudgePairs, contactByTime_onlyWhereAsked) {
  runWithGap(0.06, 2.0);
  EXPECT_EQ(verdict(), Verdict::warning) << "0.03 s, but contact_time is 0";
  setup_.limits.contact_time = 0.04;
  runWithGap(0.06, 2.0);
  EXPECT_EQ(verdict(), Verdict::contact);
  runWithGap(0.06, -2.0);
  EXPECT_EQ(verdict(), Verdict::clear) << "what parts is judged by its distance alone";
}

/// A ball that rests beside another, and a third, 5 m off, nobody knows how fast.
TEST_F(JudgePairsOfThree, velocityOfAFarLinkNotKnown_noTimeIsKnown) {
  poses_.world_from_link[1].translation.x() = 0.3;
  poses_.world_from_link[2].translation.x() = 5.0;
  poses_.velocities.known = {1, 1, 0};
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact)) << "0.5 s are enough at 20 m/s";
  poses_.velocities.known = {1, 1, 1};
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(buffers_.events.time_to_contact, kInfinity);
}

TEST(JudgePairsOfLinks, severalShapesPerLink_verdictIsThatOfTheNearest) {
  const Pose far{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, 3)};
  const CycleSetup setup =
      handMadeSetup({{0, Sphere{0.1}}, {1, Capsule{0.1, 0.1}, far}, {1, Sphere{0.1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[1].translation.x() = 0.23;
  runCycle(setup, poses, buffers);
  ASSERT_EQ(buffers.events.verdicts.size(), 1U);
  EXPECT_EQ(buffers.events.verdicts[0], Verdict::warning);
  const PairDistance& closest = buffers.distances.pairs[buffers.events.closest[0]];
  EXPECT_EQ(setup.table[closest.pair].b, BodyId{2});
}

}  // namespace
}  // namespace collision_monitor::test
