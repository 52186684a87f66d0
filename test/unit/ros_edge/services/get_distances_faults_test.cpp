// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "get_distances_scene.h"

namespace collision_monitor::test {
namespace {

class GetDistancesFaults : public GetDistancesScene {};

TEST_F(GetDistancesFaults, aMillionUnknownNames_areAFewAndHowManyMore) {
  for (int i = 0; i < 1'000'000; ++i) {
    request_.links_a.push_back("unknown" + std::to_string(i % 500'000));
  }
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("'unknown4'"), std::string::npos) << response.message;
  EXPECT_NE(response.message.find("; 499995 more"), std::string::npos) << response.message;
  EXPECT_LT(response.message.size(), 1000U);
}

TEST_F(GetDistancesFaults, everyFaultIsNamed) {
  request_.links_a = {"tol"};
  request_.links_b = {"antenna"};
  request_.max_distance = std::nan("");
  move("slid", 0.0);
  move("mast", 0.0);
  move("follow", 0.0);
  move("reach", std::numeric_limits<double>::infinity());
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.distances.closest, -1) << "there is no pair";
  for (const char* text :
       {"links_a[0]: there is no link 'tol', did you mean 'tool'",
        "links_b[0]: link 'antenna' has no collision geometry", "max_distance is nan",
        "did you mean 'slide'", "'mast' is fixed, and", "'follow' follows 'slide'",
        "joints.position[3], of joint 'reach', is inf; accepted: -1e9 to 1e9"}) {
    EXPECT_NE(response.message.find(text), std::string::npos) << text << " in " << response.message;
  }
}

TEST_F(GetDistancesFaults, jointThatStandsTwice_isNamedWithItsFirstEntry) {
  move("slide", 0.0);
  move("reach", 0.0);
  move("slide", 0.1);
  EXPECT_EQ(ask().message, "joints.name[2]: joint 'slide' stands at [0], too; give it once");
}

TEST_F(GetDistancesFaults, nameWithoutPosition_namesTheField) {
  move("slide", 0.0);
  request_.joints.name.emplace_back("reach");
  EXPECT_EQ(ask().message,
            "joints.name has 2 names for 1 position; give one position for each name");
}

TEST_F(GetDistancesFaults, unknownNames_areAnsweredWithThoseThatAreAccepted) {
  request_.links_a = {"antena"};  // like a link without shapes
  move("nothing", 0.0);
  const std::string message = ask().message;
  EXPECT_EQ(message.find("did you mean"), std::string::npos) << message;
  EXPECT_NE(message.find("links_a[0]: there is no link 'antena'; accepted: "), std::string::npos)
      << message;
  EXPECT_NE(message.find("joints.name[0]: there is no joint 'nothing'; accepted: "),
            std::string::npos)
      << message;
  for (const char* refused : {"antenna", "mast", "follow"}) {
    EXPECT_EQ(message.find(refused), std::string::npos) << refused << " in " << message;
  }
}

TEST_F(GetDistancesFaults, positionBeyondSense_isRefused) {
  move("reach", 1e155);  // the square of which is infinite
  EXPECT_FALSE(ask().success);
  EXPECT_EQ(ask().message,
            "joints.position[0], of joint 'reach', is 1e+155; accepted: -1e9 to 1e9");
}

TEST_F(GetDistancesFaults, namesAndPositionsOfDifferentNumber) {
  request_.joints.name = {"slide", "reach"};
  request_.joints.position = {0.0};
  EXPECT_FALSE(ask().success);
  request_.joints.name = {"slide", "slide"};
  request_.joints.position = {0.0, 1.0};
  EXPECT_FALSE(ask().success) << "twice the same joint";
}

TEST_F(GetDistancesFaults, ignoredPairs_areNamedWithTheirReason) {
  request_.links_a = {"base"};
  request_.links_b = {"slider"};
  const auto none = ask();
  EXPECT_FALSE(none.success);
  EXPECT_NE(none.message.find("base and slider (ignored: the links meet at a joint)"),
            std::string::npos)
      << none.message;
  request_.links_b = {"slider", "tool"};
  EXPECT_TRUE(ask().success);
}

TEST_F(GetDistancesFaults, tooManyPairsOfObjects_areRefusedUnlessLinksAreNamed) {
  std::vector<WorldObject> objects;
  for (int i = 0; i < 400; ++i) {
    objects.push_back(objectOf("ball_" + std::to_string(i), Sphere{0.01}, at(0.0, 9.0, 0.1 * i)));
  }
  setup_ = slidingSetupWith(objects);
  poses_ = slidingPoses(setup_->setup.model, 0.0, 0.25);
  request_.include_ignored = 1;
  const GetDistances::Response all = ask();
  EXPECT_FALSE(all.success);
  EXPECT_EQ(all.message,
            "include_ignored asks for 400 x 400 pairs of two objects; accepted: at most 100000, so "
            "name links in links_a or links_b");
  request_.links_a = {"ball_7"};
  const GetDistances::Response one = ask();
  EXPECT_TRUE(one.success) << one.message;
  EXPECT_GE(one.distances.pairs.size(), 399U);
  EXPECT_EQ(one.reasons.size(), one.distances.pairs.size());
}

TEST_F(GetDistancesFaults, linkAndItself_theReasonIsNamed) {
  request_.links_a = {"tool"};
  request_.links_b = {"tool"};
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message,
            "no pair of these links is checked; a link is not checked with itself, and no other "
            "link with collision geometry is asked for");
}

TEST_F(GetDistancesFaults, allPairsOfAllLinksIgnored_theyAreNamed) {
  SetupOptions options;
  options.ignored_pairs = {{"*", "*"}};
  setup_ = slidingSetup(options);
  poses_ = slidingPoses(setup_->setup.model, 0.0, 0.25);
  const auto response = ask();
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("base and tool (ignored: parameter ignore_pairs)"),
            std::string::npos)
      << response.message;
}

}  // namespace
}  // namespace collision_monitor::test
