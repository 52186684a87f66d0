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

TEST_F(RobotStates, ofARobotThatFallsSilentWhileItIsNear_countForTheOther) {
  setup_->listed[1].may_be_absent = true;
  for (const double x : {1.1, 1.23, 1.5}) {  // a contact, a warning, and clear
    place("right/hand", {x, 0.0, 0.0});
    const auto before = watchNow();
    const LinkPoses known = poses_;
    lose("right/hand");
    const auto after = watchNow(before.get());
    poses_ = known;
    const State state = stateOf(*after);
    const bool was_near = x < 1.4;
    EXPECT_EQ(state.robots[0].level, was_near ? State::UNKNOWN : State::OK) << x;
    EXPECT_EQ(state.robots[0].speed_scale, was_near ? 0.0 : 1.0) << x;
    const std::string& sentence = state.robots[0].sentence;
    EXPECT_EQ(sentence.find("absent, so only links with known poses count: robot 'right'") ==
                  std::string::npos,
              was_near)
        << sentence;
  }
}

/// Whether the robot falls silent while the pairs are muted, or in the first cycle after.
class RobotStatesAfterAMute : public RobotStates, public testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(During, RobotStatesAfterAMute, testing::Bool());

TEST_P(RobotStatesAfterAMute, ofARobotThatFallsSilent_countForTheOther) {
  setup_->listed[1].may_be_absent = true;
  place("right/hand", {1.1, 0.0, 0.0});
  const auto before = watchNow();
  const auto unmuted = setup_;
  setup_ = std::make_shared<MonitorSetup>(*unmuted);
  const CycleSetup& setup = unmuted->setup;
  SetupReport report;
  const DocumentText rules{"mute", "- {a: 'left/*', b: 'right/*', check: false}"};
  setup_->setup =
      withPairRules(setup, setup.limits,
                    readPairRules(rules, setup.model, {}, IdleRule::is_error, report), report);
  const auto fall_silent = [&] {
    lose("right/hand");
    lose("right/base");
  };
  if (GetParam()) {
    fall_silent();
  }
  const auto muted = watchNow(before.get());
  setup_ = unmuted;
  fall_silent();
  const auto after = watchNow(muted.get());
  EXPECT_EQ(stateOf(*after).robots[0].level, State::UNKNOWN);
  EXPECT_EQ(stateOf(*after).robots[0].speed_scale, 0.0);
}

TEST_F(RobotStates, sentenceOfAContact_namesNoRobotThatCounts) {
  setup_->listed[1].may_be_absent = true;
  place("right/hand", {1.1, 0.0, 0.0});
  const auto before = watchNow();
  lose("right/hand");
  place("right/base", {0.1, 0.0, 0.0});  // in contact with the left one, and known
  const auto after = watchNow(before.get());
  const std::string& sentence = stateOf(*after).robots[0].sentence;
  EXPECT_EQ(sentence.find("absent"), std::string::npos) << sentence;
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
  setup_->listed[2].has_come = true;
  state = stateNow();
  EXPECT_EQ(state.robots[0].level, State::UNKNOWN) << "it is there, and nobody watches it";
  EXPECT_EQ(state.unknown_links, std::vector<std::string>{"robot third (faulty description)"});
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

TEST_F(RobotStates, timeToContactBesideAnUnknownMotion_isUnknown) {
  poses_.velocities.known[link("right/hand")] = 0;
  State state = stateNow();
  EXPECT_TRUE(std::isnan(state.time_to_contact)) << "from any distance";
  EXPECT_TRUE(std::isnan(state.robots[0].time_to_contact));
  EXPECT_TRUE(std::isnan(state.robots[1].time_to_contact));
  place("right/hand", {1.23, 0.0, 0.0});
  state = stateNow();
  EXPECT_TRUE(std::isnan(state.robots[0].time_to_contact)) << "of a measured pair";
  EXPECT_EQ(state.robots[0].level, State::WARNING);
}

TEST_F(RobotStates, unknownMotionOfARobotThatIsAbsent_doesNotCountForTheOther) {
  setup_->listed[1].may_be_absent = true;
  lose("right/hand");
  poses_.velocities.known[link("right/hand")] = 0;
  const State state = stateNow();
  EXPECT_TRUE(std::isinf(state.robots[0].time_to_contact));
  EXPECT_TRUE(std::isnan(state.robots[1].time_to_contact));
}

TEST_F(RobotStates, whileARobotIsMissing_timesToContactBeyondTheHorizonAreUnknown) {
  EXPECT_TRUE(std::isinf(stateNow().time_to_contact));
  addThird(false);
  State state = stateNow();
  EXPECT_TRUE(std::isnan(state.time_to_contact));
  EXPECT_TRUE(std::isnan(state.robots[0].time_to_contact));
  setup_->listed[2].may_be_absent = true;
  state = stateNow();
  EXPECT_TRUE(std::isnan(state.time_to_contact));
  EXPECT_TRUE(std::isinf(state.robots[0].time_to_contact)) << "it does not wait for the third";
  place("right/hand", {1.23, 0.0, 0.0});
  poses_.velocities.of_link[link("right/hand")].linear.x() = -0.2;
  EXPECT_NEAR(stateNow().time_to_contact, 0.15, 1e-9) << "soon enough whoever comes";
}

TEST_F(RobotStates, sentenceNamesOnlyMissingRobotsThatStopIt) {
  setup_->listed.push_back({"tug", std::nullopt, "no URDF in parameter /tug", true});
  addThird(false);
  const State state = stateNow();
  EXPECT_EQ(state.robots[0].sentence,
            "robot 'third' is missing: no URDF in parameter /third; " +
                stateOf(*watchNow()).sentence.substr(stateOf(*watchNow()).sentence.find("left/")));
  EXPECT_NE(state.sentence.find("robot 'tug' is missing"), std::string::npos);
}

TEST_F(RobotStates, scalesThatWereZeroForAMissingRobot_doNotJumpWhenItComes) {
  place("right/hand", {1.23, 0.0, 0.0});
  poses_.velocities.of_link[link("right/hand")].linear.x() = -0.2;
  const auto complete = std::make_shared<MonitorSetup>(*setup_);
  addThird(false);
  const auto before = watchNow();
  ASSERT_EQ(stateOf(*before).speed_scale, 0.0);
  ASSERT_EQ(stateOf(*before).robots[0].speed_scale, 0.0);
  ASSERT_NEAR(before->buffers.robots.scales[0], 0.4, 1e-9) << "as if it were not missing";
  setup_ = complete;
  poses_.stamp_ns += 10'000'000;
  const State state = stateOf(*watchNow(before.get()));
  EXPECT_LT(state.speed_scale, 0.1);
  EXPECT_LT(state.robots[0].speed_scale, 0.1);
}

TEST_F(RobotStates, scaleOfARobotThatCame_growsFromZero) {
  place("right/hand", {1.23, 0.0, 0.0});
  poses_.velocities.of_link[link("right/hand")].linear.x() = -0.2;
  const auto complete = std::make_shared<MonitorSetup>(*setup_);
  setup_->listed[0].may_be_absent = setup_->listed[1].may_be_absent = true;
  setup_->listed[1].id.reset();
  const auto before = watchNow();
  setup_ = complete;
  poses_.stamp_ns += 10'000'000;
  const State state = stateOf(*watchNow(before.get()));
  EXPECT_LT(state.robots[1].speed_scale, 0.1);
  EXPECT_NEAR(state.robots[0].speed_scale, 0.4, 1e-9) << "it was free to go on";
}

TEST_F(RobotStates, distance_isThatOfTheClosestPairOfTheState) {
  place("right/hand", {1.1, 0.0, 0.0});
  const auto watch = watchNow();
  PairEvents& events = watch->buffers.events;
  std::vector<PairDistance>& pairs = watch->buffers.distances.pairs;
  // Another entry of the link pair is deeper, but an estimate represents the pair.
  pairs.push_back(pairs.at(events.closest_of_all));
  pairs.back().measured.distance = -0.5;
  const State state = stateOf(*watch);
  EXPECT_EQ(state.robots[0].distance, state.closest.distance);
}

TEST_F(RobotStates, whileSwitchedOff_orWithoutTime_vouchForNothing) {
  CycleFacts off = factsNow();
  off.is_enabled = false;
  off.enabled_again_in = 12.0;
  EXPECT_EQ(stateNow(off).robots[0].sentence.rfind("switched off for another 12 s; clear", 0), 0U);
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
  setup_->setup = withPairs(setup_->setup, {});
  const State state = stateNow();
  EXPECT_EQ(state.robots[0].level, State::UNKNOWN) << "nothing of it is checked";
  EXPECT_EQ(state.robots[0].speed_scale, 0.0);
}

}  // namespace
}  // namespace collision_monitor::test
