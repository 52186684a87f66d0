// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/scale_speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "two_balls.h"

namespace collision_monitor::test {
namespace {

class ScaleSpeed : public TwoBalls {};

class ScaleSpeedOfThree : public ThreeBalls {
 protected:
  /// Ball i belongs to robot i.
  void makeRobots() {
    const Robot robot = setup_.model.robots.front();
    setup_.model.robots = {robot, robot, robot};
    for (std::size_t i = 0; i < 3; ++i) {
      setup_.model.links[i].robot = idAt<RobotId>(i);
    }
    buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  }
  std::vector<double> scalesOfRobots() const {
    const std::vector<double>& all = buffers_.robots.scales;
    return {all.begin(), all.end() - 1};
  }
};

TEST_F(ScaleSpeed, slowsWhatClosesAndFreesWhatParts) {
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

TEST_F(ScaleSpeed, growsSlowlyWhileSomethingCloses) {
  runWithGap(0.03, 0.8);
  EXPECT_NEAR(scale(), 0.1, 1e-12);
  runWithGap(0.03, 0.1);
  EXPECT_NEAR(scale(), 0.12, 1e-12) << "10 ms of the 0.5 s";
}

/// A controller that multiplies a speed of 1 m/s by the scale of three cycles ago.
TEST_F(ScaleSpeed, inAClosedLoop_stopsAtTheStopDistanceWithoutChattering) {
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

TEST_F(ScaleSpeed, ofWhatTouchesAndRests_isThatOfCreeping) {
  runWithGap(-0.01, 0.0);
  EXPECT_EQ(scale(), 0.0);
  setup_.ahead.stop.creep_scale = 0.05;
  runWithGap(-0.01, 0.0);
  EXPECT_NEAR(scale(), 0.02, 1e-12) << "slowly here, too";
  runWithGap(-0.01, 0.1);
  EXPECT_EQ(scale(), 0.0);
}

TEST_F(ScaleSpeed, withoutVelocities_goesByDistance) {
  runWithGap(0.03, 0.0);
  poses_.velocities.known[0] = 0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(scale(), 0.5, 1e-12) << "half way from warning_distance to stop_distance";
}

TEST_F(ScaleSpeed, whileALinkIsUnknown_isZero) {
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
TEST_F(ScaleSpeedOfThree, everyPairIsLookedAt) {
  poses_.world_from_link[1].translation.x() = 0.22;   // 20 mm, parts
  poses_.world_from_link[2].translation.x() = -0.23;  // 30 mm, closes at 0.2 m/s
  poses_.velocities.of_link[1].linear.x() = 0.5;
  poses_.velocities.of_link[2].linear.x() = 0.2;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(buffers_.memory.speed.scale, 0.4, 1e-12);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.15, 1e-12);
}

TEST_F(ScaleSpeedOfThree, stopDistanceBeyondReportDistance_holdsForPairsThatAreNotTheClosest) {
  setup_.ahead.stop.stop_distance = 0.4;
  buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  poses_.world_from_link[1].translation.x() = 0.3;  // rests, 0.1 m away
  poses_.world_from_link[2].translation.y() = 0.5;  // closes, 0.3 m away
  poses_.velocities.of_link[2].linear.y() = -0.01;
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(scale(), 0.0);
}

TEST_F(ScaleSpeedOfThree, eachRobot_isSlowedByItsOwnPairs) {
  makeRobots();
  poses_.world_from_link[1].translation.x() = 0.23;  // 30 mm, closes at 0.2 m/s
  poses_.world_from_link[2].translation.x() = 5.0;
  poses_.velocities.of_link[1].linear.x() = -0.2;
  runCycle(setup_, poses_, buffers_);
  EXPECT_NEAR(scale(), 0.4, 1e-12);
  EXPECT_NEAR(scalesOfRobots()[0], 0.4, 1e-12);
  EXPECT_NEAR(scalesOfRobots()[1], 0.4, 1e-12);
  EXPECT_EQ(scalesOfRobots()[2], 1.0);
}

TEST_F(ScaleSpeedOfThree, unknownRobot_stopsTheOthersUnlessItIsExcused) {
  makeRobots();
  poses_.world_from_link[1].translation.x() = 5.0;
  poses_.status[2] = LinkStatus::missing;
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(scalesOfRobots(), (std::vector<double>{0.0, 0.0, 0.0}));
  buffers_.robots.is_excused[2] = 1;
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(scalesOfRobots(), (std::vector<double>{1.0, 1.0, 0.0}));
  EXPECT_EQ(scale(), 0.0) << "of all: somebody is unknown";
}

TEST_F(ScaleSpeedOfThree, excusedRobotsOwnPair_stopsIt) {
  makeRobots();
  poses_.world_from_link[1].translation.x() = 5.0;
  setup_.model.links[1].robot = RobotId{2};
  buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  poses_.status[2] = LinkStatus::missing;
  buffers_.robots.is_excused[2] = 1;
  runCycle(setup_, poses_, buffers_);
  EXPECT_EQ(scalesOfRobots(), (std::vector<double>{1.0, 1.0, 0.0}));
}

/// Ball 1 is a tool in the hand of robot 0, and ball 2 stands in a frame of its own.
TEST_F(ScaleSpeedOfThree, attachedObject_slowsTheRobotThatHoldsIt) {
  makeRobots();
  setup_.model.robots[1].is_world = setup_.model.robots[2].is_world = true;
  Joint joint;
  joint.parent = LinkId{0};
  joint.child = LinkId{1};
  setup_.model.joints.push_back(joint);
  setup_.model.links[1].parent_joint = JointId{0};
  buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  EXPECT_EQ(buffers_.robots.robot_of_link, (std::vector<std::uint32_t>{0, 0, 1}));
  poses_.world_from_link[0].translation.x() = 5.0;
  poses_.world_from_link[1].translation.x() = 0.23;
  poses_.velocities.of_link[1].linear.x() = -0.2;
  runCycle(setup_, poses_, buffers_);
  ASSERT_EQ(scalesOfRobots().size(), 1U);
  EXPECT_NEAR(scalesOfRobots()[0], 0.4, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
