// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/link_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "support/instruction_sets.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

/// Balls of 0.1 m: A at the origin, B at (1, 0, 0), C at (0, 2, 0). At most 5 mm ask for less than
/// full speed; 0.2 m are reported; the horizon is 2 s.
class FindReachesTest : public testing::TestWithParam<std::int64_t> {
 protected:
  FindReachesTest() {
    setup_.ahead.horizon = 2.0;
    setup_.ahead.stop.stop_distance = 0.0;
    reaches_ = makeActivationDistances(setup_);
    poses_.world_from_link[1].translation.x() = 1.0;
    poses_.world_from_link[2].translation.y() = 2.0;
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
  }
  /// A and B, A and C, B and C.
  std::vector<double> reaches() {
    findActivationDistances(setup_, poses_, robots_, sweep_, reaches_);
    return {reaches_.of(0), reaches_.of(1), reaches_.of(2)};
  }

  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  LinkPoses poses_ = knownPoses(setup_);
  RobotSpeeds robots_ = makeRobotSpeeds(setup_.model);
  SweepWork sweep_ = makeSweepWork(setup_);
  ActivationDistances reaches_;

 private:
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(FindReachesTest, atRest_whatIsReported) {
  EXPECT_EQ(reaches(), std::vector<double>(3, 0.2));
}

TEST_P(FindReachesTest, movingLink_asFarAsItsBallComesSeenFromTheOther) {
  // About the world's z axis at 1 rad/s: B's center goes at 1 m/s and turns its surface by
  // 0.1 m/s, C, seen from B, which turns, goes backwards at 2 m/s.
  poses_.velocities.of_link[1].angular.z() = 1.0;
  EXPECT_NEAR(reaches()[0], 0.005 + 2.0 * (1.0 + 0.1), 1e-12);
  EXPECT_EQ(reaches()[1], 0.2);
  EXPECT_NEAR(reaches()[2], 0.005 + 2.0 * (2.0 + 0.1), 1e-12);
}

TEST_P(FindReachesTest, contactExpectedSoon_laterOnesDoNotMatter) {
  poses_.velocities.of_link[1].linear.z() = 1.0;
  setup_.ahead.stop.stop_time = 0.25;
  setup_.limits.warning_time = 0.0;
  reaches_ = makeActivationDistances(setup_);
  robots_.expected[0].distance = 0.03;
  robots_.expected[0].time = 0.5;
  EXPECT_EQ(reaches(), (std::vector<double>{0.505, 0.03, 0.505}));
  robots_.expected[0].time = 0.0;
  robots_.expected[0].scale = 0.5;
  EXPECT_EQ(reaches(), (std::vector<double>{0.13, 0.03, 0.13})) << "0.125 s until the stop";
  setup_.limits.warning_time = 0.25;
  reaches_ = makeActivationDistances(setup_);
  EXPECT_NEAR(reaches()[0], 0.255 + setup_.limits.time_hysteresis, 1e-12) << "a warning by time";
}

TEST_P(FindReachesTest, velocityThatIsNotKnown_noMotionAheadMatters) {
  poses_.velocities.of_link[0].linear.y() = 1.0;
  poses_.velocities.known[2] = 0;
  EXPECT_EQ(reaches(), (std::vector<double>{2.005, 0.2, 0.2}));
  setup_.ahead.stop.stop_distance = 0.3;
  reaches_ = makeActivationDistances(setup_);
  EXPECT_DOUBLE_EQ(reaches()[2], 0.3 + setup_.limits.hysteresis);
  setup_.is_continuous = true;
  sweep_.link_motions[2].travel.x() = 0.5;
  EXPECT_DOUBLE_EQ(reaches()[2], 0.5) << "the way since the last cycle";
}

TEST_P(FindReachesTest, velocityBeyondAllNumbers_everythingMatters) {
  poses_.velocities.of_link[0].linear.y() = kInfinity;
  EXPECT_EQ(reaches(), (std::vector<double>{kInfinity, kInfinity, 0.2}));
}

TEST_P(FindReachesTest, linksThatCameFar_wayOfBoth) {
  setup_.is_continuous = true;
  sweep_.link_motions[0].travel.x() = 0.5;
  sweep_.link_motions[1].travel.y() = 0.25;
  EXPECT_EQ(reaches(), (std::vector<double>{0.75, 0.5, 0.25}));
  setup_.is_continuous = false;
  EXPECT_EQ(reaches(), std::vector<double>(3, 0.2));
}

TEST_P(FindReachesTest, step_byThePairThatComesFarthestForItsThickness) {
  std::fill(sweep_.has_motion.begin(), sweep_.has_motion.end(), 1);
  sweep_.link_motions[2].travel.z() = 0.1;
  sweep_.link_motions[1].travel.z() = -0.1;
  reaches();
  EXPECT_EQ(sweep_.step.at_poses.pair, kNone) << "no time has passed";
  sweep_.elapsed = 0.01;
  reaches();
  // B and C: 0.2 m in 10 ms, together 0.4 m thick.
  EXPECT_EQ(sweep_.step.at_poses.pair, 2U);
  EXPECT_NEAR(sweep_.step.at_poses.longest, 0.02, 1e-12);
  EXPECT_EQ(sweep_.step.on_way.pair, 2U) << "the way is not looked at";
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, FindReachesTest, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

}  // namespace
}  // namespace collision_monitor::test
