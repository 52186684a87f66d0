// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/get_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "get_distances_scene.h"
#include "support/robots/geometry_setup.h"

namespace collision_monitor::test {
namespace {

class GetDistancesTest : public GetDistancesScene {};

TEST_F(GetDistancesTest, noNames_everyCheckedPairByDistance) {
  const auto response = ask();
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.distances.pairs.size(), 3U);
  EXPECT_EQ(response.distances.pairs_checked, 3U);
  EXPECT_EQ(response.distances.closest, 0);
  EXPECT_EQ(response.distances.header.stamp, ros::Time(12.5));
  EXPECT_EQ(response.distances.header.frame_id, "base");
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 0.55, 1e-12);
  EXPECT_NEAR(distanceOf(response, "base", "finger"), 0.8, 1e-12);
  EXPECT_LE(response.distances.pairs[0].distance, response.distances.pairs[1].distance);
  EXPECT_EQ(response.distances.pairs[0].quality, LinkDistance::EXACT);
}

TEST_F(GetDistancesTest, setsOfLinks_inEitherOrder) {
  request_.links_a = {"tool"};
  request_.links_b = {"base", "finger"};
  const auto response = ask();
  ASSERT_EQ(response.distances.pairs.size(), 2U);
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 0.55, 1e-12);
}

TEST_F(GetDistancesTest, maxDistance_leavesFarPairsOut) {
  request_.max_distance = 0.6;
  const auto response = ask();
  ASSERT_EQ(response.distances.pairs.size(), 1U);
  EXPECT_EQ(response.distances.pairs[0].link_b, "tool");
  EXPECT_EQ(response.distances.pairs_checked, 3U);
}

TEST_F(GetDistancesTest, nothingWithinMaxDistance_theClosestIsToldAllTheSame) {
  request_.max_distance = 0.1;
  const auto response = ask();
  ASSERT_TRUE(response.success);
  ASSERT_EQ(response.distances.pairs.size(), 1U);
  EXPECT_EQ(response.distances.closest, 0);
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 0.55, 1e-12);
  EXPECT_FALSE(response.distances.pairs[0].gradient_values.empty());
  EXPECT_EQ(response.message,
            "3 pairs measured, 0 unknown; none within 100 mm, the nearest: base is 550 mm from "
            "tool");
  request_.links_a = {"finger"};
  EXPECT_NEAR(distanceOf(ask(), "base", "finger"), 0.8, 1e-12) << "of those asked for";
}

/// Of enclosing shapes the box at the corner is nearer, of geometries the one beside.
TEST_F(GetDistancesTest, nothingWithinMaxDistance_theClosestIsThatOfGeometries) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  auto made = std::make_shared<MonitorSetup>();
  made->setup = linkSetup({{{"angle", Pose(), angleMesh()}},
                           {{"corner", Pose(), Box{{0.01, 0.01, 0.01}}}},
                           {{"beside", Pose(), Box{{0.01, 0.01, 0.01}}}}},
                          options);
  setup_ = made;
  poses_ = makeLinkPoses(made->setup.model);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
  poses_.world_from_link[1].translation = {0.36, 0.36, 0.0};
  poses_.world_from_link[2].translation = {-0.15, 0.05, 0.0};
  const auto all = ask();
  request_.max_distance = 1e-3;
  const auto none = ask();
  ASSERT_FALSE(all.distances.pairs.empty());
  ASSERT_EQ(none.distances.pairs.size(), 1U) << none.message;
  EXPECT_EQ(none.distances.pairs[0].shape_b, "beside");
  EXPECT_EQ(all.distances.pairs[0].shape_b, "beside");
  EXPECT_EQ(none.distances.pairs[0].distance, all.distances.pairs[0].distance);
  EXPECT_EQ(none.distances.pairs[0].quality, LinkDistance::EXACT);
}

TEST_F(GetDistancesTest, ignoredPairsOfTwoObjects_areMeasuredOnceAndNamedWithTheirReason) {
  setup_ = slidingSetupWith({objectOf("crate", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 2.0)),
                             objectOf("ball", Sphere{0.1}, at(0.0, 0.0, 2.5))});
  poses_ = slidingPoses(setup_->setup.model, 0.0, 0.25);
  request_.links_a = {"crate", "ball", "base"};
  request_.links_b = {"ball", "crate"};
  EXPECT_TRUE(std::isnan(distanceOf(ask(), "crate", "ball")));
  request_.include_ignored = 1;
  const GetDistances::Response response = ask();
  ASSERT_EQ(response.distances.pairs.size(), 3U) << response.message;
  ASSERT_EQ(response.reasons.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const LinkDistance& pair = response.distances.pairs[i];
    if (pair.link_a != "base" && pair.link_b != "base") {
      EXPECT_NEAR(pair.distance, 0.3, 1e-9);
      EXPECT_EQ(response.reasons[i], "ignored: two objects that move together");
    }
  }
}

TEST_F(GetDistancesTest, namedJointMoves_othersStay) {
  move("reach", -0.1);
  EXPECT_NEAR(distanceOf(ask(), "base", "tool"), 0.2, 1e-12);
}

TEST_F(GetDistancesTest, mimicJointsFollowTheirSource) {
  move("slide", 0.3);
  const auto response = ask();
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 0.85, 1e-12);
  EXPECT_NEAR(distanceOf(response, "base", "finger"), std::sqrt(2.0) * 0.8, 1e-12);
}

TEST_F(GetDistancesTest, mimicJointBesideItsSource_isDerived) {
  move("slide", 0.3);
  move("follow", 77.0);
  EXPECT_NEAR(distanceOf(ask(), "base", "finger"), std::sqrt(2.0) * 0.8, 1e-12);
}

TEST_F(GetDistancesTest, unknownLink_pairsOfQualityUnknown) {
  lose("tool");
  const auto response = ask();
  ASSERT_TRUE(response.success);
  EXPECT_EQ(response.distances.pairs_unknown, 2U);
  ASSERT_EQ(response.distances.pairs.size(), 3U);
  EXPECT_EQ(response.distances.pairs[0].link_b, "finger");
  EXPECT_EQ(response.distances.pairs[1].quality, LinkDistance::UNKNOWN);
  EXPECT_TRUE(std::isnan(response.distances.pairs[1].distance));
}

TEST_F(GetDistancesTest, jointGivenForAnUnknownLink_makesItKnown) {
  lose("tool");
  move("reach", 0.0);
  EXPECT_NEAR(distanceOf(ask(), "base", "tool"), 0.3, 1e-12);
}

TEST_F(GetDistancesTest, nothingKnownButTheRoot_unnamedJointsStayUnknown) {
  lose("slider");
  lose("tool");
  lose("finger");
  move("reach", 0.0);
  EXPECT_EQ(ask().distances.pairs_unknown, 3U) << "the slider carries all of them";
  move("slide", 0.0);
  EXPECT_EQ(ask().distances.pairs_unknown, 0U);
}

/// A box goes through an angle and, deeper, through a box that is padded as all of them are.
TEST_F(GetDistancesTest, contactThatIsCertain_isNotHiddenByADeeperBound) {
  SetupOptions options;
  options.padding = 0.01;
  Pose aside;
  aside.translation = {0.5, 0.05, 0.0};
  auto made = std::make_shared<MonitorSetup>();
  made->setup =
      linkSetup({{{"angle", Pose(), angleMesh()}, {"cube", aside, Box{{0.05, 0.05, 0.05}}}},
                 {{"bar", Pose(), Box{{0.3, 0.04, 0.04}}}}},
                options);
  setup_ = made;
  poses_ = makeLinkPoses(made->setup.model);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
  poses_.world_from_link[1].translation = {0.55, 0.05, 0.0};
  const auto response = ask();
  ASSERT_EQ(response.distances.pairs.size(), 1U) << response.message;
  EXPECT_EQ(response.distances.pairs[0].quality, LinkDistance::ESTIMATE);
  EXPECT_EQ(response.distances.pairs[0].shape_a, "angle");
}

TEST_F(GetDistancesTest, partThatFloats_itsOwnPairsAreMeasured) {
  floatSlider(setup_->setup.model, poses_);
  const auto response = ask();
  ASSERT_TRUE(response.success);
  EXPECT_NEAR(distanceOf(response, "tool", "finger"), std::hypot(0.45, 0.8), 1e-9);
  EXPECT_EQ(response.distances.pairs[0].frame_id, "slider");
  EXPECT_EQ(response.distances.header.frame_id, "base");
  EXPECT_EQ(response.distances.pairs_unknown, 2U);
  EXPECT_TRUE(std::isnan(distanceOf(response, "base", "tool")));
  EXPECT_EQ(response.message,
            "1 pair measured, 2 unknown; the part of robot 'r' from link 'slider' on floats: "
            "it is not known where it stands");
  request_.links_a = request_.links_b = {"tool", "finger"};
  EXPECT_EQ(ask().message, "1 pair measured, 0 unknown");
}

TEST_F(GetDistancesTest, jointThatJoinsTwoParts_measuresAllPairs) {
  floatSlider(setup_->setup.model, poses_);
  move("slide", 0.5);
  const auto response = ask();
  EXPECT_EQ(response.distances.pairs_unknown, 0U) << response.message;
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 1.05, 1e-9);
  EXPECT_EQ(response.distances.pairs[0].frame_id, "base");
}

TEST_F(GetDistancesTest, rootThatIsNotKnown_isNoReasonForUnknown) {
  poses_ = makeLinkPoses(setup_->setup.model);
  EXPECT_EQ(ask().message,
            "0 pairs measured, 3 unknown; link base is unknown: no transform from 'world' to "
            "'base' yet (and 2 more)");
  move("slide", 0.0);
  move("reach", 0.25);
  const auto response = ask();
  EXPECT_EQ(response.distances.pairs_unknown, 0U) << response.message;
  EXPECT_NEAR(distanceOf(response, "base", "tool"), 0.55, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
