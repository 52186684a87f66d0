// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/newest_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision_monitor/model/kinematics.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

/// A joint of each kind, one after the other, none along a main axis.
class NewestStateTest : public testing::Test {
 protected:
  NewestStateTest()
      : model_(readText(robotXml("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
                                 "<link name='e'/>" +
                                 jointXml("slide", "prismatic", "a", "b", with("-9", "9")) +
                                 jointXml("bend", "revolute", "b", "c", with("2", "5")) +
                                 jointXml("wind", "revolute", "c", "d", with("-6", "6")) +
                                 jointXml("spin", "continuous", "d", "e", with("0", "0"))))
                   .model) {}

  static std::string with(const std::string& lower, const std::string& upper) {
    return "<origin xyz='1 2 3' rpy='0.3 0.2 0.1'/><axis xyz='1 -2 0.5'/><limit lower='" + lower +
           "' upper='" + upper + "'/>";
  }
  NewestState stateAt(const JointPositions& positions) const {
    NewestState newest = makeNewestState(model_);
    placeLinks(model_, positions, {Pose()}, newest.poses.world_from_link);
    std::fill(newest.poses.status.begin(), newest.poses.status.end(), LinkStatus::known);
    return newest;
  }
  std::optional<double> positionOf(const NewestState& newest, const std::string& joint,
                                   double target = 0.0) const {
    return newestPosition(model_, newest, *model_.findJoint(joint), target);
  }

  RobotModel model_;
};

TEST_F(NewestStateTest, posesTellPositions) {
  for (const double share : {-0.99, -0.3, 0.0, 0.4, 0.99}) {
    const NewestState newest = stateAt({9.0 * share, 3.5 + 1.5 * share, 0.1, 3.1 * share});
    EXPECT_NEAR(positionOf(newest, "slide").value(), 9.0 * share, 1e-12);
    EXPECT_NEAR(positionOf(newest, "bend").value(), 3.5 + 1.5 * share, 1e-12);
    EXPECT_NEAR(positionOf(newest, "spin").value(), 3.1 * share, 1e-12);
  }
}

TEST_F(NewestStateTest, jointOfSeveralTurns_onlyJointStatesTell) {
  NewestState newest = stateAt({0.0, 3.0, 1.0, 0.0});
  EXPECT_FALSE(positionOf(newest, "wind")) << "1 or 1 - 6.28";
  newest.positions[2] = -5.28;
  EXPECT_EQ(positionOf(newest, "wind"), -5.28);
}

TEST_F(NewestStateTest, continuousJoint_isTheShorterWayFromTheTarget) {
  NewestState newest = stateAt({0.0, 3.0, 0.0, 0.5});
  EXPECT_NEAR(positionOf(newest, "spin", 100.0).value(), 0.5 + 16.0 * 6.283185307179586, 1e-12);
  newest.positions[3] = -100.0;
  EXPECT_NEAR(positionOf(newest, "spin", 0.0).value(), -100.0 + 16.0 * 6.283185307179586, 1e-12);
}

/// A motor that turns without limits, and a joint that follows it.
std::optional<double> motorPosition(const std::string& type, double multiplier, double told) {
  const RobotModel model =
      readText(robotXml("<link name='a'/><link name='b'/><link name='c'/>" +
                        jointXml("motor", "continuous", "a", "b") +
                        jointXml("driven", type, "a", "c",
                                 "<limit lower='-9' upper='9'/><mimic joint='motor' multiplier='" +
                                     std::to_string(multiplier) + "'/>")))
          .model;
  NewestState newest = makeNewestState(model);
  std::fill(newest.poses.status.begin(), newest.poses.status.end(), LinkStatus::known);
  newest.positions[0] = told;
  return newestPosition(model, newest, *model.findJoint("motor"), 0.0);
}

TEST_F(NewestStateTest, continuousJointThatMovesOthers_isWhereItIsUnlessTheyComeRound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(motorPosition("prismatic", 0.01, 7.0), 7.0) << "the slide is 70 mm off";
  EXPECT_FALSE(motorPosition("prismatic", 1.0, nan)) << "poses do not tell turns";
  EXPECT_EQ(motorPosition("revolute", -0.5, 7.0), 7.0);
  EXPECT_NEAR(motorPosition("continuous", -2.0, 7.0).value(), 7.0 - 6.283185307179586, 1e-12);
}

TEST_F(NewestStateTest, unknownLink_itsJointsAreUnlessJointStatesTell) {
  NewestState newest = stateAt({0.3, 3.0, 0.0, 0.0});
  newest.poses.status[1] = LinkStatus::stale;
  EXPECT_FALSE(positionOf(newest, "slide"));
  EXPECT_FALSE(positionOf(newest, "bend"));
  EXPECT_TRUE(positionOf(newest, "spin"));
  newest.positions[0] = 0.2;
  EXPECT_EQ(positionOf(newest, "slide"), 0.2);
}

TEST_F(NewestStateTest, linksOfTwoParts_tellNothing) {
  NewestState newest = stateAt({1.0, 3.0, 0.1, 0.5});
  newest.poses.part[2] = newest.poses.part[3] = newest.poses.part[4] = 2;
  EXPECT_FALSE(positionOf(newest, "bend"));
  EXPECT_NEAR(positionOf(newest, "slide").value(), 1.0, 1e-12);
  EXPECT_NEAR(positionOf(newest, "spin").value(), 0.5, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
