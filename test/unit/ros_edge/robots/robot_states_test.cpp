// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/robot_states.h"

#include <gtest/gtest.h>

#include <cmath>

#include "two_arms.h"

namespace collision_monitor::test {
namespace {

class RobotStates : public TwoArms {
 protected:
  void addThird(bool may_be_absent) {
    setup_->listed.push_back({"third", std::nullopt, "no URDF in parameter /third", may_be_absent});
  }
};

TEST_F(RobotStates, ofRobotsFarFromEachOther_areClear) {
  const State state = stateNow();
  ASSERT_EQ(state.robots.size(), 2U);
  for (const RobotState& robot : state.robots) {
    EXPECT_EQ(robot.level, State::OK);
    EXPECT_EQ(robot.speed_scale, 1.0);
    EXPECT_TRUE(robot.has_description != 0);
  }
  EXPECT_EQ(state.robots[0].name, "left");
  EXPECT_EQ(state.robots[1].name, "right");
}

TEST_F(RobotStates, ofAPairThatCloses_areThoseOfBothRobots) {
  place("right/hand", {1.23, 0.0, 0.0});
  poses_.velocities.of_link[link("right/hand")].linear.x() = -0.2;
  const State state = stateNow();
  for (const RobotState& robot : state.robots) {
    EXPECT_EQ(robot.level, State::WARNING);
    EXPECT_NEAR(robot.distance, 0.03, 1e-9);
    EXPECT_NEAR(robot.speed_scale, 0.4, 1e-9);
    EXPECT_NEAR(robot.time_to_contact, 0.15, 1e-9);
    EXPECT_EQ(robot.sentence,
              "left/hand is 30 mm from right/hand, closing at 0.20 m/s, contact in 0.15 s");
  }
}

TEST_F(RobotStates, ofAnUnknownRobot_areUnknownForTheOtherToo) {
  lose("right/hand");
  const State state = stateNow();
  EXPECT_EQ(state.level, State::UNKNOWN);
  for (const RobotState& robot : state.robots) {
    EXPECT_EQ(robot.level, State::UNKNOWN);
    EXPECT_EQ(robot.speed_scale, 0.0);
    EXPECT_EQ(robot.sentence.rfind("link right/hand is unknown: ", 0), 0U) << robot.sentence;
  }
}

TEST_F(RobotStates, ofARobotThatMayBeAbsentAndIs_doNotCountForTheOther) {
  setup_->listed[1].may_be_absent = true;
  lose("right/hand");
  const State state = stateNow();
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.speed_scale, 0.0);
  EXPECT_EQ(state.robots[0].level, State::OK);
  EXPECT_EQ(state.robots[0].speed_scale, 1.0);
  EXPECT_EQ(state.robots[1].level, State::UNKNOWN);
  EXPECT_EQ(state.robots[1].speed_scale, 0.0);
  place("right/base", {1.23, 0.0, 0.0});  // what is known of it still counts
  EXPECT_EQ(stateNow().robots[0].level, State::WARNING);
}

TEST_F(RobotStates, whileARobotIsMissing_areUnknownUnlessItMayBeAbsent) {
  addThird(false);
  State state = stateNow();
  ASSERT_EQ(state.robots.size(), 3U);
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.speed_scale, 0.0);
  EXPECT_EQ(state.sentence.rfind("robot 'third' is missing: no URDF in parameter /third; ", 0), 0U)
      << state.sentence;
  EXPECT_EQ(state.unknown_links, std::vector<std::string>{"robot third (no description)"});
  EXPECT_EQ(state.robots[0].level, State::UNKNOWN);
  EXPECT_EQ(state.robots[0].speed_scale, 0.0);
  EXPECT_TRUE(state.robots[2].has_description == 0);
  EXPECT_EQ(state.robots[2].level, State::UNKNOWN);
  EXPECT_EQ(state.robots[2].sentence, "no URDF in parameter /third");
  setup_->listed[2].may_be_absent = true;
  state = stateNow();
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.robots[0].level, State::OK);
  EXPECT_EQ(state.robots[0].speed_scale, 1.0);
}

TEST_F(RobotStates, whileARobotIsMissing_aContactIsStillTheWorst) {
  addThird(false);
  place("right/hand", {1.1, 0.0, 0.0});
  const State state = stateNow();
  EXPECT_EQ(state.level, State::CONTACT);
  EXPECT_EQ(state.robots[0].level, State::CONTACT);
  EXPECT_EQ(state.sentence,
            "left/hand overlaps right/hand by 100 mm; robot 'third' is missing: no URDF in "
            "parameter /third");
}

TEST_F(RobotStates, whileSwitchedOff_orWithoutTime_vouchForNothing) {
  CycleFacts off = factsNow();
  off.is_enabled = false;
  for (const RobotState& robot : stateNow(off).robots) {
    EXPECT_EQ(robot.level, State::WARNING);
    EXPECT_EQ(robot.speed_scale, 0.0);
  }
  for (const RobotState& robot : stateNow(CycleFacts()).robots) {
    EXPECT_EQ(robot.level, State::UNKNOWN);
    EXPECT_EQ(robot.speed_scale, 0.0);
    EXPECT_EQ(robot.sentence, "no time on /clock yet");
    EXPECT_TRUE(std::isnan(robot.distance));
  }
}

TEST_F(RobotStates, ofAPairOfOthers_doNotCountForTheThird) {
  setup_->setup =
      withPairs(setup_->setup, std::vector<bool>(setup_->setup.link_pairs.size(), false));
  const State state = stateNow();
  EXPECT_EQ(state.robots[0].level, State::UNKNOWN) << "nothing of it is checked";
  EXPECT_EQ(state.robots[0].speed_scale, 0.0);
}

}  // namespace
}  // namespace collision_monitor::test
