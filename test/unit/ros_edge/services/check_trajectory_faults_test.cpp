// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/State.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check_trajectory_scene.h"

namespace collision_monitor::test {
namespace {

class CheckTrajectoryFaults : public CheckTrajectoryScene {};

TEST_F(CheckTrajectoryFaults, manyUnknownJointsAndBadPoints_areAFewAndHowManyMore) {
  for (int i = 0; i < 100'000; ++i) {
    request_.trajectory.joint_names.push_back("unknown" + std::to_string(i));
    addPoint(1.0 + i, 0.0);
  }
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("99995 more; joint_names[0]: there is no joint 'unknown0'"),
            std::string::npos)
      << response.message;
  EXPECT_EQ(response.message.substr(response.message.size() - 12), "; 99995 more");
}

TEST_F(CheckTrajectoryFaults, everyFaultIsNamed) {
  request_.margin = std::nan("");
  request_.trajectory.joint_names = {"reac"};
  addPoint(0.0, 0.0);
  addPoint(0.0, 1.0);
  addPoint(1.0, 1.0);
  request_.trajectory.points[1].velocities = {0.0};
  request_.trajectory.points[2].positions = {0.0, 1.0};
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.level, State::UNKNOWN);
  for (const char* text : {"margin is nan; give finite metres", "did you mean 'reach'",
                           "points[1].velocities is not empty",
                           "points[1].time_from_start is 0 s; accepted: later than the 0 s",
                           "points[2].positions has 2 numbers for 1 joint;"}) {
    EXPECT_NE(response.message.find(text), std::string::npos) << text << " in " << response.message;
  }
}

TEST_F(CheckTrajectoryFaults, numberThatIsNotFinite_namesJointAndPoint) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(0.0, 0.0);
  addPoint(1.0, std::numeric_limits<double>::infinity());
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "points[1].positions of joint 'reach' is inf; accepted: -1e9 to 1e9");
  request_.trajectory = trajectory_msgs::JointTrajectory();
  EXPECT_FALSE(ask().success) << "nothing is named";
}

TEST_F(CheckTrajectoryFaults, velocityThatLeadsBeyondSenseBeforeTheFirstPoint_isRefused) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(4.0, 0.25);
  request_.trajectory.points[0].velocities = {1e9};
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message,
            "points[0].velocities of joint 'reach' is 1e+09, which leads 4e+09 far until the "
            "point next to it; accepted: at most 1e9 far");
}

/// The way to there is infinite in squares, and what is infinite exceeds what is needed: the way
/// through the base seemed clear.
TEST_F(CheckTrajectoryFaults, numberBeyondSense_namesJointPointAndWhatIsAccepted) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(1.0, 0.25);
  addPoint(3.0, -1e155);
  auto response = ask();
  EXPECT_FALSE(response.success) << response.message;
  EXPECT_EQ(response.message,
            "points[1].positions of joint 'reach' is -1e+155; accepted: -1e9 to 1e9");
  request_.trajectory.points[1].positions = {-1e9};
  response = ask();
  EXPECT_EQ(response.level, State::CONTACT) << response.message;
}

TEST_F(CheckTrajectoryFaults, timeBeforeTheStart_namesThePointAndWhatIsAccepted) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(-5.0, 0.25);
  addPoint(2.0, 0.5);
  auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "points[0].time_from_start is -5 s; accepted: 0 s or later");
  request_.trajectory.points[0].time_from_start = ros::Duration(3.5);
  response = ask();
  EXPECT_EQ(
      response.message,
      "points[1].time_from_start is 2 s; accepted: later than the 3.5 s of the point before it");
}

/// The difference of the two is no Duration.
TEST_F(CheckTrajectoryFaults, timesFarApart_areNoException) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(-2e9, 0.25);
  addPoint(2e9, 0.5);
  auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "points[0].time_from_start is -2e+09 s; accepted: 0 s or later");
  request_.trajectory.points[0].time_from_start = ros::Duration(0.0);
  request_.trajectory.points[1].time_from_start.sec = std::numeric_limits<std::int32_t>::max();
  request_.trajectory.points[1].time_from_start.nsec = std::numeric_limits<std::int32_t>::max();
  response = ask();
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.level, State::OK);
}

TEST_F(CheckTrajectoryFaults, velocityThatLeadsBeyondSense_namesJointPointAndWhatIsAccepted) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(1.0, 0.25);
  addPoint(4.0, -1.25);
  request_.trajectory.points[0].velocities = {0.0};
  request_.trajectory.points[1].velocities = {-1e300};
  auto response = ask();
  EXPECT_FALSE(response.success) << response.message;
  EXPECT_EQ(response.message,
            "points[1].velocities of joint 'reach' is -1e+300; accepted: -1e9 to 1e9");
  request_.trajectory.points[1].velocities = {-1e9};
  response = ask();
  EXPECT_FALSE(response.success) << response.message;
  EXPECT_EQ(response.message,
            "points[1].velocities of joint 'reach' is -1e+09, which leads 3e+09 far until the "
            "point next to it; accepted: at most 1e9 far");
}

}  // namespace
}  // namespace collision_monitor::test
