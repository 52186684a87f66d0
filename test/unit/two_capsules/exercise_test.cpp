// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exercise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/expect_distance.h"

namespace collision_monitor::two_capsules {
namespace {

using Eigen::Vector3d;

Exercise afterClicks(const Points& points) {
  Exercise exercise;
  for (const Vector3d& point : points) {
    takeClick(point, exercise);
    EXPECT_EQ(exercise.refusal, "");
  }
  return exercise;
}

/// Lies along x from (0, 0, 0) to (0.4, 0, 0), 0.1 thick.
const Points kAlongX{{0.0, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.4, 0.0, 0.0}};

Exercise secondAfterX(const Vector3d& end, const Vector3d& rim, const Vector3d& other_end) {
  Points points = kAlongX;
  points.insert(points.end(), {end, rim, other_end});
  return afterClicks(points);
}

void expectRefused(const Vector3d& point, const std::string& why, Exercise exercise) {
  const std::size_t count = exercise.clicks.size();
  takeClick(point, exercise);
  EXPECT_EQ(exercise.refusal, why);
  EXPECT_EQ(exercise.clicks.size(), count);
}

TEST(Exercise, threeClicks_areEndRadiusAndOtherEnd) {
  EXPECT_TRUE(capsulesOf(afterClicks({kAlongX[0]})).empty());

  const auto growing = capsulesOf(afterClicks({kAlongX[0], kAlongX[1]}));
  ASSERT_EQ(growing.size(), 1U);
  EXPECT_EQ(std::get<Capsule>(growing[0].shape).half_length, 0.0);
  EXPECT_EQ(std::get<Capsule>(growing[0].shape).radius, 0.1);
  EXPECT_EQ(growing[0].geometry_from_body.translation, kAlongX[0]);

  const auto whole = capsulesOf(afterClicks(kAlongX));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(std::get<Capsule>(whole[0].shape).half_length, 0.2);
  EXPECT_EQ(std::get<Capsule>(whole[0].shape).radius, 0.1);
  EXPECT_EQ(whole[0].geometry_from_body.translation, Vector3d(0.2, 0.0, 0.0));
  EXPECT_EQ(whole[0].geometry_from_body.rotation.col(2), Vector3d::UnitX());
}

TEST(Exercise, distance_isThereOnceBothStand) {
  Points points = kAlongX;
  points.insert(points.end(), {{0.2, 0.5, 0.0}, {0.2, 0.5, 0.15}});
  EXPECT_FALSE(distanceOf(afterClicks({})));
  EXPECT_FALSE(distanceOf(afterClicks(points)));
}

TEST(Exercise, endAboveMiddle_distanceIsBetweenCoresLessRadii) {
  const auto found = distanceOf(secondAfterX({0.2, 0.5, 0.0}, {0.05, 0.5, 0.0}, {0.2, 0.9, 0.0}));
  ASSERT_TRUE(found);
  test::expectDistance(*found, 0.25, Vector3d::UnitY(), {0.2, 0.1, 0.0});
}

TEST(Exercise, parallelCapsules_distanceIsAcross) {
  const auto found = distanceOf(secondAfterX({0.4, 0.0, 0.5}, {0.4, 0.05, 0.5}, {0.0, 0.0, 0.5}));
  ASSERT_TRUE(found);
  // The middle of what they share.
  test::expectDistance(*found, 0.35, Vector3d::UnitZ(), {0.2, 0.0, 0.1});
}

TEST(Exercise, crossingCores_overlapByBothRadii) {
  const auto found = distanceOf(secondAfterX({0.2, -0.3, 0.0}, {0.25, -0.3, 0.0}, {0.2, 0.3, 0.0}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance, -0.15, test::kExact);
  EXPECT_NEAR(std::abs(found->normal_a_to_b.z()), 1.0, test::kExact);
  test::expectConsistent(*found);
}

TEST(Exercise, equalEnds_areASphere) {
  const auto found = distanceOf(secondAfterX({0.7, 0.4, 0.0}, {0.7, 0.4, 0.2}, {0.7, 0.4, 0.0}));
  ASSERT_TRUE(found);
  // 3, 4, 5: from the end at (0.4, 0, 0) along (0.6, 0.8, 0).
  test::expectDistance(*found, 0.5 - 0.1 - 0.2, {0.6, 0.8, 0.0}, {0.46, 0.08, 0.0});
}

TEST(Exercise, badClicks_areRefusedAndChangeNothing) {
  const std::string not_a_place = "refused: a click must be finite and within 1000 m";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused({0.0, nan, 0.0}, not_a_place, {});
  expectRefused({0.0, 0.0, std::numeric_limits<double>::infinity()}, not_a_place, {});
  expectRefused({-1000.1, 0.0, 0.0}, not_a_place, afterClicks(kAlongX));

  const std::string thin = "refused: the rim must be 1 mm or more from the end";
  expectRefused({0.0, 0.0009, 0.0}, thin, afterClicks({kAlongX[0]}));
  expectRefused({0.2, 0.5, 0.0}, "refused: both capsules stand",
                secondAfterX({0.2, 0.5, 0.0}, {0.2, 0.6, 0.0}, {0.2, 0.9, 0.0}));
}

TEST(Exercise, goodClick_clearsTheRefusal) {
  Exercise exercise = afterClicks({kAlongX[0]});
  takeClick(kAlongX[0], exercise);
  EXPECT_EQ(promptOf(exercise),
            "refused: the rim must be 1 mm or more from the end\n"
            "capsule 1: click a point on the rim, which sets the radius");
  takeClick(kAlongX[1], exercise);
  EXPECT_EQ(promptOf(exercise), "capsule 1: click the other end");
}

TEST(Exercise, prompt_saysWhatComesNext) {
  EXPECT_EQ(promptOf({}), "capsule 1: click one end");
  EXPECT_EQ(promptOf(afterClicks(kAlongX)), "capsule 2: click one end");
  EXPECT_EQ(promptOf(secondAfterX({0.2, 0.5, 0.0}, {0.2, 0.6, 0.0}, {0.2, 0.9, 0.0})),
            "press R in the terminal to start again");
}

TEST(Exercise, distanceText_saysOverlapInsteadOfASign) {
  EXPECT_EQ(distanceText(0.1234), "0.123 m");
  EXPECT_EQ(distanceText(-0.02), "overlap 0.020 m");
  EXPECT_EQ(distanceText(12.5), "12.500 m");
  EXPECT_EQ(distanceText(-0.0004), "touching");
  EXPECT_EQ(distanceText(0.0), "touching");
}

}  // namespace
}  // namespace collision_monitor::two_capsules
