// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/State.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "support/robots/urdf_text.h"
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

/// A cart with a trailer that only planar joints move: no JointState can.
class CheckStatesOfCart : public CheckStatesServiceTest {
 protected:
  CheckStatesOfCart() {
    const std::string cube = "<box size='0.2 0.2 0.2'/>";
    auto made = std::make_shared<MonitorSetup>();
    const std::string flat = "<axis xyz='0 0 1'/>";
    const std::string xml =
        linkXml("hall", cube) + linkXml("cart", cube) + linkXml("trailer", cube) +
        jointXml("drive", "planar", "hall", "cart", flat) +
        jointXml("hitch", "planar", "cart", "trailer", "<origin xyz='5 0 0'/>" + flat);
    made->setup = buildSetup({describeText(robotXml(xml))}, textLoader({}), SetupOptions());
    made->world_frame = "hall";
    setup_ = made;
    poses_ = makeLinkPoses(made->setup.model);
    placeLinks(made->setup.model, {0.5, 0.0, 0.0, 0.5, 0.0, 0.0}, {Pose()}, poses_.world_from_link);
    std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
    std::fill(poses_.part.begin(), poses_.part.end(), kWorldPart);
  }
};

TEST_F(CheckStatesOfCart, withoutJoints_theNewestStateIsJudged) {
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.levels, std::vector<std::uint8_t>{State::OK});
  EXPECT_NEAR(response.distances[0], 5.8, 1e-9) << "hall and trailer";
}

TEST_F(CheckStatesOfCart, whatCanBeGiven_isSaid) {
  request_.positions = {0.0, 1.0};
  EXPECT_EQ(ask().message,
            "positions has 2 values, but no joint of this robot can be given; leave it empty");
  request_.joint_names = {"drive", "nothing"};
  EXPECT_EQ(
      ask().message,
      "joint_names[0]: joint 'drive' is planar, and a JointState cannot place it; leave it "
      "out; joint_names[1]: there is no joint 'nothing'; no joint of this robot can be given");
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
