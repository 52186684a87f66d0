// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/State.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "unit/ros_edge/services/check_states_scene.h"

namespace collision_monitor::test {
namespace {

using CheckStatesFaults = CheckStatesServiceTest;

TEST_F(CheckStatesFaults, invalidNumberOfAMimicJoint_makesItsStateUnknown) {
  request_.joint_names = {"reach", "slide", "follow"};
  request_.positions = {0.0, 0.0, std::nan(""), 0.0, 0.0, 1e10, 0.0, 0.0, 1.0};
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.levels,
            (std::vector<std::uint8_t>{State::UNKNOWN, State::UNKNOWN, State::OK}));
}

TEST_F(CheckStatesFaults, aMillionUnknownJoints_areAFewAndHowManyMore) {
  for (int i = 0; i < 1'000'000; ++i) {
    request_.joint_names.push_back("unknown" + std::to_string(i));
  }
  request_.joint_names.push_back("reach");
  request_.positions.resize(request_.joint_names.size(), 0.0);
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("there is no joint 'unknown4'"), std::string::npos);
  EXPECT_NE(response.message.find("; 999995 more"), std::string::npos) << response.message;
  EXPECT_LT(response.message.size(), 1000U);
}

TEST_F(CheckStatesFaults, oddNames_areShortenedAndHarmless) {
  request_.joint_names = {std::string(30'000'000, 'a'), "\x1b[2Jreach"};
  request_.positions = {0.0, 0.0};
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_LT(response.message.size(), 1000U);
  EXPECT_NE(response.message.find("[... of 30000000 bytes ...]"), std::string::npos);
  EXPECT_NE(response.message.find("there is no joint '\\x1b[2Jreach'"), std::string::npos)
      << response.message;
}

TEST_F(CheckStatesFaults, faults_areNamedAndNothingIsChecked) {
  EXPECT_NE(ask().message.find("joint_names is empty"), std::string::npos);
  request_.joint_names = {"reach", "slyde", "follow"};
  request_.positions = {0.0, 1.0};
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("joint_names[1]: there is no joint 'slyde'"), std::string::npos);
  EXPECT_NE(response.message.find("joint_names[2]: joint 'follow' follows 'slide'"),
            std::string::npos);
  EXPECT_NE(response.message.find("positions has 2 values for 3 joints"), std::string::npos);
  EXPECT_TRUE(response.levels.empty());
}

}  // namespace
}  // namespace collision_monitor::test
