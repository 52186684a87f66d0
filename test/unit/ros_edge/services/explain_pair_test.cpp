// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/explain_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test::explain_pair {
namespace {

class ExplainPairTest : public EdgeScene {
 protected:
  ExplainPair::Response explain(const std::string& a, const std::string& b, const Watch& watch) {
    ExplainPair::Request request;
    request.link_a = a;
    request.link_b = b;
    NewestState newest = makeNewestState(watch.setup().model);
    newest.poses = watch.poses;
    ExplainPair::Response response;
    const auto view = [&](const std::string& one, const std::string& other) {
      return std::optional<PairView>(viewOf(watch, one, other));
    };
    answerExplainPair(*watch.fixed, newest, view, request, response);
    return response;
  }
};

void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
}

TEST_F(ExplainPairTest, warning_saysWhichThresholdItIs) {
  const auto watch = watchAt(-0.26);  // 0.04 m apart
  const ExplainPair::Response response = explain("tool", "base", *watch);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_TRUE(response.checked);
  EXPECT_EQ(response.reason, "checked: no rule says otherwise");
  EXPECT_EQ(response.level, State::WARNING);
  expectIn(response.level_reason, "the distance is at most warning_distance, 0.05 m");
  EXPECT_NEAR(response.now.distance, 0.04, 1e-9);
  EXPECT_EQ(response.limit_names.size(), kLimitFields.size());
  EXPECT_EQ(response.limit_places.front(), "limits");
}

TEST_F(ExplainPairTest, thresholdOfARule_isNamedWithIt) {
  SetupReport report;
  auto made = std::make_shared<MonitorSetup>(*setup_);
  const CycleSetup& setup = setup_->setup;
  made->setup =
      withPairRules(setup, setup.limits,
                    readPairRules({"rules.yaml", "- {a: base, b: tool, warning_distance: 0.06}"},
                                  setup.model, {}, IdleRule::is_error, report),
                    report);
  setup_ = made;
  const auto watch = watchAt(-0.25);  // 0.05 m apart
  expectIn(explain("tool", "base", *watch).level_reason,
           "the distance is at most warning_distance, 0.06 m (rules.yaml line 1, rule 1)");
}

TEST_F(ExplainPairTest, nearestThatIsABound_isSaidToBeOne) {
  const auto watch = watchAt(-0.2);
  watch->cycle();
  EXPECT_EQ(explain("base", "tool", *watch).nearest_quality, LinkDistance::EXACT);
  for (PairDistance& distance : watch->buffers.distances.pairs) {
    distance.measured.distance -= 0.02;
    distance.quality = Quality::lower_bound;
  }
  watch->nearest.add(watch->setup(), watch->poses, watch->joints, watch->buffers);
  const ExplainPair::Response response = explain("base", "tool", *watch);
  EXPECT_EQ(response.nearest_quality, LinkDistance::LOWER_BOUND);
  expectIn(response.message, "nearest since start: at least 80 mm");
}

TEST_F(ExplainPairTest, adjacentLinks_areMeasuredAndSaidToBeIgnored) {
  const auto watch = watchAt(0.0);
  const ExplainPair::Response response = explain("slider", "base", *watch);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_FALSE(response.checked);
  EXPECT_EQ(response.reason, "ignored: the links meet at a joint");
  EXPECT_NEAR(response.now.distance, 4.8, 1e-9);
  EXPECT_TRUE(std::isnan(response.nearest));
}

TEST_F(ExplainPairTest, twoObjectsThatFormNoPair_areMeasuredAndSaidToBeIgnored) {
  setup_ = slidingSetupWith({objectOf("crate", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 2.0)),
                             objectOf("ball", Sphere{0.1}, at(0.0, 0.0, 2.5))});
  const auto watch = watchAt(0.0);
  const ExplainPair::Response response = explain("crate", "ball", *watch);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_FALSE(response.checked);
  EXPECT_EQ(response.reason, "ignored: two objects that move together");
  EXPECT_NEAR(response.now.distance, 0.3, 1e-9);
  expectIn(response.message, "now object ball is 300 mm from object crate");
}

TEST_F(ExplainPairTest, nearest_isKeptWithItsJointValues) {
  const auto watch = watchAt(-0.2);  // 0.1 m apart
  watch->cycle();
  watch->poses = slidingPoses(setup_->setup.model, 0.3, 0.3);
  watch->cycle();
  const ExplainPair::Response response = explain("base", "tool", *watch);
  EXPECT_NEAR(response.now.distance, 0.9, 1e-9);
  EXPECT_NEAR(response.nearest, 0.1, 1e-9);
  EXPECT_EQ(response.nearest_joints, (std::vector<std::string>{"slide", "reach"}));
  ASSERT_EQ(response.nearest_positions.size(), 2U);
  EXPECT_NEAR(response.nearest_positions[0], 0.0, 1e-9);
  EXPECT_NEAR(response.nearest_positions[1], -0.2, 1e-9);
  EXPECT_EQ(response.nearest_stamp, ros::Time(12.5));
  expectIn(response.message, "nearest since start: 100 mm at slide 0.000, reach -0.200");
}

TEST_F(ExplainPairTest, nearest_isTakenOverWithItsJointValues) {
  const auto former = watchAt(-0.2);
  former->cycle();
  const auto watch = watchAt(0.3);
  watch->takeOver(*former);
  watch->cycle();
  const ExplainPair::Response response = explain("base", "tool", *watch);
  EXPECT_GT(response.now.distance, 0.5);
  EXPECT_NEAR(response.nearest, 0.1, 1e-9);
  ASSERT_EQ(response.nearest_positions.size(), 2U);
  EXPECT_NEAR(response.nearest_positions[1], -0.2, 1e-9);
}

TEST_F(ExplainPairTest, unknownLink_isTheReason) {
  const auto watch = watchAt(0.0);
  watch->poses.status[index(linkNamed(setup_->setup.model, "tool"))] = LinkStatus::stale;
  watch->cycle();
  const ExplainPair::Response response = explain("base", "tool", *watch);
  EXPECT_EQ(response.level, State::UNKNOWN);
  expectIn(response.level_reason, "the pose of tool is stale");
  EXPECT_EQ(response.now.quality, LinkDistance::UNKNOWN);
}

TEST_F(ExplainPairTest, whatIsNoPair_isRefused) {
  const auto watch = watchAt(0.0);
  const ExplainPair::Response unknown = explain("tol", "antenna", *watch);
  EXPECT_FALSE(unknown.success);
  expectIn(unknown.message, "did you mean 'tool'?");
  expectIn(unknown.message, "'antenna' has no collision geometry");
  EXPECT_FALSE(explain("tool", "tool", *watch).success);
}

}  // namespace
}  // namespace collision_monitor::test::explain_pair
