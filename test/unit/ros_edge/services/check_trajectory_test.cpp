// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/check_trajectory.h"

#include <collision_monitor/State.h>
#include <gtest/gtest.h>

#include <cmath>

#include "check_trajectory_scene.h"

namespace collision_monitor::test {
namespace {

class CheckTrajectoryTest : public CheckTrajectoryScene {};

TEST_F(CheckTrajectoryTest, contact_firstPairTimeAndPoints) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(1.0, 0.25);
  addPoint(3.0, -1.25);  // through the base, which it touches at -0.3
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.level, State::CONTACT);
  EXPECT_NEAR(response.contact_time, 1.0 + 2.0 * 0.55 / 1.5, 1e-5);
  EXPECT_EQ(response.message, "first contact after 1.733 s: base touches tool");
  ASSERT_EQ(response.pairs.size(), 3U);
  EXPECT_EQ(response.pairs_checked, 3U);
  const LinkApproach& first = response.pairs[0];
  EXPECT_EQ(first.state, LinkApproach::CONTACT);
  EXPECT_EQ(first.nearest.link_b, "tool");
  EXPECT_EQ(first.nearest.quality, LinkDistance::EXACT);
  EXPECT_NEAR(first.nearest.point_on_a.x, 0.1, 1e-5);
  EXPECT_EQ(find(response, "base", "finger")->state, LinkApproach::CLEAR);
}

TEST_F(CheckTrajectoryTest, whileARobotIsMissing_noPathIsClear) {
  auto made = std::make_shared<MonitorSetup>(*setup_);
  made->listed.push_back({"late", std::nullopt, "no URDF in parameter /late", true});
  setup_ = made;
  request_.trajectory.joint_names = {"reach"};
  addPoint(0.0, 0.25);
  addPoint(1.0, 0.2);
  const auto response = ask();
  EXPECT_EQ(response.level, State::UNKNOWN);
  EXPECT_NE(response.message.find("robot 'late' is missing: no URDF in parameter /late"),
            std::string::npos)
      << response.message;
}

TEST_F(CheckTrajectoryTest, nearMiss_isAWarningWithItsNearestApproach) {
  request_.trajectory.joint_names = {"slide"};
  request_.margin = 0.3;
  addPoint(0.0, 0.0);
  addPoint(1.0, -0.3);  // base to tool 0.55 - 0.3; base to finger stays beside
  addPoint(2.0, 0.0);
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.level, State::WARNING);
  EXPECT_TRUE(std::isnan(response.contact_time));
  const LinkApproach& nearest = response.pairs[0];
  EXPECT_EQ(nearest.nearest.link_b, "tool");
  EXPECT_NEAR(nearest.nearest.distance, 0.25, 1e-12);
  EXPECT_EQ(nearest.time, 1.0);
  EXPECT_GE(nearest.at_least, 0.249);
  EXPECT_EQ(response.message, "no contact; nearest after 1.000 s, base 250 mm from tool");
  request_.margin = 0.1;
  EXPECT_EQ(ask().level, State::OK);
}

TEST_F(CheckTrajectoryTest, longAnswers_leaveOutWhatStaysFar) {
  TrajectoryReport report;
  report.pairs.resize(10'000);
  for (PairApproach& pair : report.pairs) {
    pair.state = ApproachState::clear;
    pair.at_least = 0.3;
  }
  EXPECT_TRUE(isTold(report, 0.05, 0));
  report.pairs.push_back(report.pairs.front());
  EXPECT_FALSE(isTold(report, 0.05, 0));
  EXPECT_TRUE(isTold(report, 0.3, 0));
  for (const ApproachState state :
       {ApproachState::contact, ApproachState::undecided, ApproachState::unknown}) {
    report.pairs[0].state = state;
    EXPECT_TRUE(isTold(report, 0.05, 0));
  }
}

TEST_F(CheckTrajectoryTest, mimicJointsFollow) {
  // The finger goes by 2 slide + 0.1 beside the slider, so it is at x = 3 slide + 0.1: the base
  // stays 1 m aside of it whatever it does, and nothing of it touches.
  request_.trajectory.joint_names = {"slide"};
  addPoint(0.0, 0.0);
  addPoint(1.0, 0.3);
  request_.margin = 2.0;
  const LinkApproach finger = *find(ask(), "base", "finger");
  EXPECT_NEAR(finger.nearest.distance, 0.8, 1e-12);
  EXPECT_LE(finger.time, 0.2) << "while 3 slide + 0.1 is within 0.2";
}

TEST_F(CheckTrajectoryTest, unknownLink_pairsAreUnknownAndSoIsTheWhole) {
  newest_.poses.status[index(linkNamed(setup_->setup.model, "finger"))] = LinkStatus::stale;
  request_.trajectory.joint_names = {"reach"};
  addPoint(0.0, 0.25);
  addPoint(1.0, 0.5);
  const auto response = ask();
  ASSERT_TRUE(response.success);
  EXPECT_EQ(response.level, State::UNKNOWN);
  EXPECT_EQ(response.pairs_unknown, 2U);
  EXPECT_EQ(find(response, "base", "finger")->state, LinkApproach::UNKNOWN);
  EXPECT_EQ(find(response, "base", "tool")->state, LinkApproach::CLEAR);
}

/// What a controller makes of one point: the way from where the robot stands.
TEST_F(CheckTrajectoryTest, firstPointLaterThanTheStart_wayToItIsChecked) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(2.0, -1.25);  // beyond the base, which is touched at -0.3
  auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.level, State::CONTACT);
  EXPECT_NEAR(response.contact_time, 2.0 * 0.55 / 1.5, 1e-5);
  EXPECT_EQ(response.message, "first contact after 0.733 s: base touches tool");
  newest_.positions[setup_->setup.model.joint(*setup_->setup.model.findJoint("reach"))
                        .first_variable] = 0.75;
  EXPECT_NEAR(ask().contact_time, 2.0 * 1.05 / 2.0, 1e-5) << "joint states tell it better";
  request_.trajectory.points[0].time_from_start = ros::Duration(0.0);
  response = ask();
  EXPECT_EQ(response.level, State::OK) << "what it begins with is there";
  EXPECT_EQ(response.pairs[0].time, 0.0);
}

TEST_F(CheckTrajectoryTest, wayToTheFirstPoint_isOnCubicsFromRest) {
  request_.trajectory.joint_names = {"reach"};
  addPoint(2.0, -1.25);
  addPoint(3.0, -1.25);
  for (trajectory_msgs::JointTrajectoryPoint& point : request_.trajectory.points) {
    point.velocities = {0.0};
  }
  // 3 s^2 - 2 s^3 = 0.55 / 1.5 of the way.
  const double share = 0.5 - std::sin(std::asin(1.0 - 2.0 * 0.55 / 1.5) / 3.0);
  EXPECT_NEAR(ask().contact_time, 2.0 * share, 1e-5);
}

TEST_F(CheckTrajectoryTest, whereJointsAreNowIsNotKnown_theMessageSaysSo) {
  newest_.poses = makeLinkPoses(setup_->setup.model);
  newest_.poses.status[index(linkNamed(setup_->setup.model, "base"))] = LinkStatus::known;
  newest_.poses.world_from_link[0] = Pose();
  request_.trajectory.joint_names = {"slide", "reach"};
  addPoint(2.0, 0.0);
  request_.trajectory.points[0].positions = {0.0, 0.25};
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.level, State::OK);
  EXPECT_EQ(response.message,
            "no contact; nearest after 2.000 s, base 550 mm from tool; the way to the first point "
            "was not checked, for it is not known where these joints are now: slide, reach");
  request_.trajectory.points[0].time_from_start = ros::Duration(0.0);
  EXPECT_EQ(ask().message, "no contact; nearest after 0.000 s, base 550 mm from tool");
}

TEST_F(CheckTrajectoryTest, partThatFloats_itsOwnPairsAreChecked) {
  floatSlider(setup_->setup.model, newest_.poses);
  request_.trajectory.joint_names = {"reach"};
  for (int i = 0; i <= 10; ++i) {  // more way-points than a block of states holds
    addPoint(i, 0.25 - 0.1 * i);
  }
  request_.margin = 1.0;
  const auto response = ask();
  ASSERT_TRUE(response.success);
  EXPECT_EQ(response.level, State::UNKNOWN);
  EXPECT_EQ(response.pairs_unknown, 2U);
  const LinkApproach* own = find(response, "tool", "finger");
  EXPECT_EQ(own->state, LinkApproach::CLEAR);
  EXPECT_NEAR(own->nearest.distance, 0.8, 1e-9);
  EXPECT_EQ(own->nearest.frame_id, "slider");
  EXPECT_EQ(find(response, "base", "tool")->state, LinkApproach::UNKNOWN);
  EXPECT_NE(response.message.find("; 2 pairs unknown; the part of robot 'r' from link 'slider' on "
                                  "floats: it is not known where it stands"),
            std::string::npos)
      << response.message;
}

TEST_F(CheckTrajectoryTest, robotThatFloatsAsAWhole_isCheckedAsOneThatStands) {
  request_.trajectory.joint_names = {"slide", "reach"};
  for (int i = 0; i <= 10; ++i) {
    addPoint(i, 0.0);
    request_.trajectory.points.back().positions = {0.0, 0.25 - 0.15 * i};
  }
  const auto standing = ask();
  EXPECT_EQ(standing.level, State::CONTACT);
  newest_.poses = makeLinkPoses(setup_->setup.model);
  const auto floating = ask();
  EXPECT_EQ(floating.level, standing.level);
  EXPECT_EQ(floating.contact_time, standing.contact_time);
  EXPECT_EQ(floating.pairs_unknown, 0U);
  EXPECT_EQ(floating.message, standing.message);
}

}  // namespace
}  // namespace collision_monitor::test
