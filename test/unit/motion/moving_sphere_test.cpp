// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/moving_sphere.h"

#include <gtest/gtest.h>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

MovingSphere straight(const Pose& start, const Eigen::Vector3d& travel, double radius) {
  Pose end = start;
  end.translation += travel;
  return movingSphereOf(screwBetween(start, end), Eigen::Vector3d::Zero(), radius);
}

TEST(MovingSphere, straightMotion_keepsTheRadius) {
  const MovingSphere sphere = straight(at(1, 2, 3), {0, 3, 4}, 0.5);
  expectNear(sphere.center, {1, 2, 3}, "center");
  expectNear(sphere.travel, {0, 3, 4}, "travel");
  EXPECT_NEAR(sphere.length, 5.0, kExact);
  EXPECT_NEAR(sphere.reach, 0.5, kExact);
  EXPECT_GE(sphere.reach, 0.5);
}

TEST(MovingSphere, turningMotion_growsByTheArc) {
  // Half a radian on a circle of radius 2: an eighth of 2 * 0.5 * 0.5.
  ScrewMotion motion;
  motion.turn = {0, 0, 0.5};
  const MovingSphere sphere = movingSphereOf(motion, {2, 0, 0}, 1.0);
  EXPECT_NEAR(sphere.reach, 1.0625, kExact);
  EXPECT_NEAR(sphere.length, 4.0 * std::sin(0.25), kExact);
}

TEST(MovingSphere, bySpeed_isTheSumOfTravels) {
  const MovingSphere a = straight(at(0, 0, 0), {0, 1, 0}, 1.0);
  // Radii 2, travels 1 and 2: they may meet from 5 m on, whichever way they go.
  EXPECT_FALSE(mayMeetBySpeed(a, straight(at(5.001, 0, 0), {0, 0, 2}, 1.0), 0.0));
  EXPECT_TRUE(mayMeetBySpeed(a, straight(at(4.999, 0, 0), {0, 0, 2}, 1.0), 0.0));
  EXPECT_TRUE(mayMeetBySpeed(a, straight(at(5.001, 0, 0), {0, 0, 2}, 1.0), 0.01));
}

TEST(MovingSphere, byClosing_onlyTheLineOfCentersCounts) {
  const MovingSphere a = straight(at(0, 0, 0), {0.5, 7, 0}, 1.0);
  // 3 m apart; A comes 0.5 nearer along the line, B what its travel says.
  EXPECT_FALSE(mayMeetByClosing(a, straight(at(5, 0, 0), {-2.499, 0, 9}, 1.0), 0.0));
  EXPECT_TRUE(mayMeetByClosing(a, straight(at(5, 0, 0), {-2.501, 0, 9}, 1.0), 0.0));
  EXPECT_FALSE(mayMeetByClosing(a, straight(at(5, 0, 0), {4, 0, 0}, 1.0), 0.0)) << "they part";
  EXPECT_TRUE(mayMeetByClosing(a, straight(at(1, 0, 0), {4, 0, 0}, 1.0), 0.0)) << "they overlap";
}

TEST(MovingSphere, sameCenter_meets) {
  const MovingSphere a = straight(at(0, 0, 0), {0, 0, 0}, 0.0);
  EXPECT_TRUE(mayMeetBySpeed(a, a, 0.0));
  EXPECT_TRUE(mayMeetByClosing(a, a, 0.0));
}

}  // namespace
}  // namespace collision_monitor::test
