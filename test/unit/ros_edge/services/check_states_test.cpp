// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/LinkDistance.h>
#include <collision_monitor/State.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/robots/urdf_text.h"
#include "unit/ros_edge/services/check_states_scene.h"

namespace collision_monitor::test {
namespace {

TEST_F(CheckStatesServiceTest, everyStateIsJudged) {
  request_.joint_names = {"reach"};
  request_.positions = {0.0, -0.28, -0.4, std::nan("")};
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.levels,
            (std::vector<std::uint8_t>{State::OK, State::WARNING, State::CONTACT, State::UNKNOWN}));
  EXPECT_NEAR(response.distances[0], 0.3, 1e-12);
  EXPECT_NEAR(response.distances[1], 0.02, 1e-12);
  EXPECT_NEAR(response.distances[2], -0.1, 1e-12);
  EXPECT_TRUE(std::isnan(response.distances[3]));
  EXPECT_EQ(response.qualities[2], LinkDistance::EXACT);
  EXPECT_EQ(response.qualities[3], LinkDistance::UNKNOWN);
  EXPECT_EQ(response.links_a[2], "base");
  EXPECT_EQ(response.links_b[2], "tool");
  EXPECT_EQ(response.links_a[3], "");
  EXPECT_EQ(response.message,
            "4 states: 1 in contact, 1 unknown; positions[3], of joint 'reach' in state 3, is nan; "
            "accepted: -1e9 to 1e9");
}

TEST_F(CheckStatesServiceTest, ofManyInvalidStates_theFirstIsNamed) {
  request_.joint_names = {"slide", "reach"};
  request_.positions = {0.0, 0.0, 0.0, 2e9, std::nan(""), 0.0, 0.0, -2e9};
  EXPECT_EQ(ask().message,
            "4 states: 0 in contact, 3 unknown; positions[3], of joint 'reach' in state 1, is "
            "2e+09; accepted: -1e9 to 1e9; 2 more such states");
}

TEST_F(CheckStatesServiceTest, whileARobotIsMissing_noStateIsClear) {
  auto made = std::make_shared<MonitorSetup>(*setup_);
  made->listed.push_back({"late", std::nullopt, "no URDF in parameter /late", true});
  setup_ = made;
  request_.joint_names = {"reach"};
  request_.positions = {0.0, -0.4};
  const auto response = ask();
  EXPECT_EQ(response.levels, (std::vector<std::uint8_t>{State::UNKNOWN, State::CONTACT}));
  EXPECT_NE(response.message.find("1 unknown; robot 'late' is missing: "), std::string::npos);
}

TEST_F(CheckStatesServiceTest, manyStates_areAllJudgedInOrder) {
  request_.joint_names = {"reach"};
  std::vector<double> done;
  progress_ = [&](double part) {
    done.push_back(part);
    return true;
  };
  for (int i = 0; i < 2500; ++i) {
    request_.positions.push_back(0.001 * i);
  }
  const auto response = ask();
  ASSERT_EQ(response.distances.size(), 2500U);
  for (std::size_t i = 0; i < 2500; ++i) {
    // base and tool; farther out the finger is nearest to the base.
    EXPECT_NEAR(response.distances[i], std::min(0.3 + 0.001 * static_cast<double>(i), 0.8), 1e-12);
  }
  EXPECT_EQ(done, (std::vector<double>{0.4, 0.8, 1.0}));
}

TEST_F(CheckStatesServiceTest, givenUp_answersNothing) {
  request_.joint_names = {"reach"};
  request_.positions.assign(2500, 0.0);
  progress_ = [](double part) { return part < 0.5; };
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_TRUE(response.levels.empty());
  EXPECT_EQ(response.message, "given up after 2000 of 2500 states: the monitor ends");
}

TEST_F(CheckStatesServiceTest, moreStatesThanACallMayHave_areRefused) {
  request_.joint_names = {"reach", "slide"};
  request_.positions.assign(200'000, 0.0);
  EXPECT_TRUE(ask().success);
  request_.positions.assign(200'002, 0.0);
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "positions has 100001 states; give at most 100000 in one call");
  EXPECT_TRUE(response.levels.empty());
}

TEST_F(CheckStatesServiceTest, positionBeyondSense_isUnknownHoweverItIsAsked) {
  request_.joint_names = {"reach"};
  request_.positions = {1e10, -1e17, 1e155};
  const std::vector<std::uint8_t> unknown(3, State::UNKNOWN);
  for (const bool is_contact : {false, true}) {
    for (const bool is_enclosed : {false, true}) {
      request_.only_contacts = is_contact ? 1 : 0;
      request_.enclosing_shapes = is_enclosed ? 1 : 0;
      EXPECT_EQ(ask().levels, unknown) << is_contact << is_enclosed;
    }
  }
}

TEST_F(CheckStatesServiceTest, jointsThatAreNotNamedStayWhereTheyAre) {
  request_.joint_names = {"slide"};
  request_.positions = {-0.5, 0.05};
  const auto response = ask();
  EXPECT_NEAR(response.distances[0], 0.05, 1e-12) << "reach is at 0.25";
  EXPECT_NEAR(response.distances[1], 0.6, 1e-12);
}

TEST_F(CheckStatesServiceTest, statesHoldTheJointsInTheOrderOfTheNames) {
  request_.joint_names = {"reach", "slide"};
  request_.positions = {0.1, 0.0, -0.1, 0.0};
  const auto response = ask();
  ASSERT_EQ(response.levels.size(), 2U);
  EXPECT_NEAR(response.distances[0], 0.4, 1e-12);
  EXPECT_NEAR(response.distances[1], 0.2, 1e-12);
}

TEST_F(CheckStatesServiceTest, onlyContacts_saysNothingOfTheRest) {
  request_.joint_names = {"reach"};
  request_.positions = {-0.28, -0.4};
  request_.only_contacts = 1;
  request_.enclosing_shapes = 1;
  const auto response = ask();
  EXPECT_EQ(response.levels, (std::vector<std::uint8_t>{State::OK, State::CONTACT}));
  EXPECT_TRUE(std::isnan(response.distances[0]));
  EXPECT_EQ(response.links_b[1], "tool");
}

TEST_F(CheckStatesServiceTest, linkThatCannotBePlaced_isUnknown) {
  poses_.status[index(linkNamed(setup_->setup.model, "tool"))] = LinkStatus::stale;
  request_.joint_names = {"slide"};
  request_.positions = {0.0};
  EXPECT_EQ(ask().levels[0], State::UNKNOWN);
  request_.joint_names = {"slide", "reach"};
  request_.positions = {0.0, 0.25};
  EXPECT_EQ(ask().levels[0], State::OK) << "a joint that is named needs no pose";
}

/// tf may tell better than the URDF where a fixed link stands, as after a calibration.
TEST_F(CheckStatesServiceTest, fixedLinksStayWhereTheyAre) {
  auto made = std::make_shared<MonitorSetup>();
  const std::string ball = "<sphere radius='0.1'/>";
  made->setup = buildSetup(
      {describeText(robotXml(linkXml("base", ball, "<origin xyz='0 0 -9'/>") +
                             linkXml("post", ball) + linkXml("tool", ball) +
                             jointXml("stand", "fixed", "base", "post", "<origin xyz='1 0 0'/>") +
                             jointXml("turn", "continuous", "base", "tool")))},
      textLoader({}), SetupOptions());
  setup_ = made;
  poses_ = makeLinkPoses(made->setup.model);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
  const std::size_t post = index(linkNamed(made->setup.model, "post"));
  poses_.world_from_link[post].translation.x() = 0.15;
  request_.joint_names = {"turn"};
  request_.positions = {0.0};
  EXPECT_NEAR(ask().distances[0], -0.05, 1e-12);
  poses_.status[post] = LinkStatus::stale;
  EXPECT_NEAR(ask().distances[0], 0.8, 1e-12) << "where nothing else is known, as the URDF says";
}

TEST_F(CheckStatesServiceTest, modelThatCannotMove_hasOneState) {
  const auto ball = [](const std::string& name) {
    return describeText("<robot name='" + name + "'>" + linkXml(name, "<sphere radius='0.1'/>") +
                        "</robot>");
  };
  auto still = std::make_shared<MonitorSetup>();
  still->setup = buildSetup({ball("left"), ball("right")}, textLoader({}), SetupOptions());
  setup_ = still;
  poses_ = makeLinkPoses(still->setup.model);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
  poses_.world_from_link[1].translation.x() = 0.15;
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.levels, std::vector<std::uint8_t>{State::CONTACT});
  EXPECT_NEAR(response.distances[0], -0.05, 1e-12);
}

TEST_F(CheckStatesServiceTest, partThatFloats_itsOwnPairsAreJudged) {
  floatSlider(setup_->setup.model, poses_);
  request_.joint_names = {"reach"};
  // Tool and finger are 0.8 m apart in y; in x they are at 0.5 + reach and 0.1.
  request_.positions = {0.0, -0.5};
  for (const bool only_contacts : {false, true}) {
    request_.only_contacts = only_contacts ? 1 : 0;
    const auto response = ask();
    EXPECT_EQ(response.levels, (std::vector<std::uint8_t>{State::UNKNOWN, State::UNKNOWN}));
    EXPECT_EQ(response.message,
              "2 states: 0 in contact, 2 unknown; the part of robot 'r' from link 'slider' on "
              "floats: it is not known where it stands");
  }
  request_.only_contacts = 0;
  const auto response = ask();
  EXPECT_NEAR(response.distances[0], std::hypot(0.2, 0.8), 1e-9);
  EXPECT_NEAR(response.distances[1], 0.8, 1e-9);
  EXPECT_EQ(response.links_a[0], "tool");
  EXPECT_EQ(response.links_b[1], "finger");
}

TEST_F(CheckStatesServiceTest, contactWithinAPartThatFloats_isTold) {
  SetupOptions options;
  options.limits.contact_distance = 0.85;
  options.limits.warning_distance = options.limits.report_distance = 0.9;
  setup_ = slidingSetup(options);
  floatSlider(setup_->setup.model, poses_);
  request_.joint_names = {"reach"};
  request_.positions = {-0.5};
  for (const bool only_contacts : {false, true}) {
    for (const bool enclosing_shapes : {false, true}) {
      request_.only_contacts = only_contacts ? 1 : 0;
      request_.enclosing_shapes = enclosing_shapes ? 1 : 0;
      const auto response = ask();
      EXPECT_EQ(response.levels[0], State::CONTACT) << response.message;
      EXPECT_EQ(response.links_a[0], "tool");
      EXPECT_NEAR(response.distances[0], 0.8, 1e-9);
    }
  }
}

TEST_F(CheckStatesServiceTest, robotThatFloatsAsAWhole_isJudgedAsOneThatStands) {
  request_.joint_names = {"slide", "reach"};
  request_.positions = {0.0, 0.0, 0.0, -0.28, 0.0, -0.4};
  const auto standing = ask();
  poses_ = makeLinkPoses(setup_->setup.model);
  const auto floating = ask();
  EXPECT_EQ(floating.levels, standing.levels);
  EXPECT_EQ(floating.distances, standing.distances);
  EXPECT_EQ(floating.message, standing.message);
}

TEST_F(CheckStatesServiceTest, robotThatFloatsBesideAnother_isUnknownToIt) {
  const std::string ball = "<sphere radius='0.1'/>";
  const auto robot = [&](const std::string& name) {
    return describeText("<robot name='" + name + "'>" + linkXml(name, ball) + "</robot>");
  };
  auto still = std::make_shared<MonitorSetup>();
  still->setup = buildSetup({robot("left"), robot("right")}, textLoader({}), SetupOptions());
  setup_ = still;
  poses_ = makeLinkPoses(still->setup.model);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
  poses_.part[1] = 1;
  poses_.part_status[1] = LinkStatus::missing;
  EXPECT_EQ(ask().levels, std::vector<std::uint8_t>{State::UNKNOWN});
}

}  // namespace
}  // namespace collision_monitor::test
