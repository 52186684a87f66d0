// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/screw_motion.h"

#include <gtest/gtest.h>

#include "geometry/constants.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

Eigen::Matrix3d aboutZ(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

/// A quarter turn about the axis through (1, 0, any), 4 m up along it; starts at the origin.
ScrewMotion quarterTurn() { return screwBetween(at(0, 0, 0), {aboutZ(0.5 * kPi), {1, -1, 4}}); }

TEST(ScrewMotion, quarterTurn_turnAndVelocityOfTheOrigin) {
  const ScrewMotion motion = quarterTurn();
  expectNear(motion.turn, {0, 0, 0.5 * kPi}, "turn");
  // On a circle of radius 1 about (1, 0), starting towards -y at pi / 2 a unit of time.
  expectNear(motion.travel, {0, -0.5 * kPi, 4}, "velocity of the origin");
}

TEST(ScrewMotion, quarterTurn_halfWayIsOnTheHelix) {
  const Pose half = poseAt(quarterTurn(), 0.5);
  const double s = std::sqrt(0.5);
  expectNear(half.translation, {1.0 - s, -s, 2}, "origin");
  expectNear(half.rotation.col(0), {s, s, 0}, "x axis");
  const Pose end = poseAt(quarterTurn(), 1.0);
  expectNear(end.translation, {1, -1, 4}, "origin at the end");
  expectNear(end.rotation.col(0), {0, 1, 0}, "x axis at the end");
}

TEST(ScrewMotion, pointOnTheAxisSlides_pointOffItGoesRound) {
  const ScrewMotion motion = quarterTurn();
  expectNear(velocityAt(motion, {1, 0, 3}), {0, 0, 4}, "on the axis");
  expectNear(velocityAt(motion, {3, 0, 0}), {0, kPi, 4}, "2 m off it");
}

TEST(ScrewMotion, noMotion_staysAndHasNoSpeed) {
  const Pose pose{aboutZ(0.3), {5, 6, 7}};
  const ScrewMotion motion = screwBetween(pose, pose);
  EXPECT_LE(motion.turn.norm(), 1e-15);
  EXPECT_EQ(motion.travel.norm(), 0.0);
  expectNear(poseAt(motion, 0.7).translation, pose.translation, "origin");
}

TEST(ScrewMotion, halfTurn_isOneOfBothAndArrives) {
  const ScrewMotion motion = screwBetween(at(0, 0, 0), {aboutZ(kPi), {2, 0, 0}});
  EXPECT_NEAR(motion.turn.norm(), kPi, kExact);
  expectNear(poseAt(motion, 1.0).translation, {2, 0, 0}, "origin at the end");
  EXPECT_NEAR(std::abs(poseAt(motion, 0.5).translation.y()), 1.0, kExact);
}

TEST(ScrewMotion, smallTurns_asExactOnBothSidesOfTheSeries) {
  for (const double angle : {1e-9, 1e-3, 0.019, 0.0199, 0.0201, 0.021, 0.1}) {
    // On a circle of radius 2 about (2, 0): the origin starts along -y.
    const double x = 2.0 * 2.0 * std::sin(0.5 * angle) * std::sin(0.5 * angle);
    const ScrewMotion motion =
        screwBetween(at(0, 0, 0), {aboutZ(angle), {x, -2.0 * std::sin(angle), 0}});
    EXPECT_NEAR(motion.turn.z(), angle, 1e-15 * (1.0 + angle));
    expectNear(motion.travel, {0, -2.0 * angle, 0}, "velocity of the origin");
  }
}

TEST(ScrewMotion, tinyTurnsAboutAFarAxis_arriveToo) {
  for (const double angle : {1e-3, 1e-4, 0.99e-4, 1e-6, 1e-9, 1e-13}) {
    const Pose end{aboutZ(angle), {0.1, -0.2, 0.3}};
    const ScrewMotion motion = screwBetween(at(0, 0, 0), end);
    const Pose reached = poseAt(motion, 1.0);
    EXPECT_LE((reached.translation - end.translation).norm(), 1e-14) << angle;
    EXPECT_LE((reached.rotation - end.rotation).norm(), 1e-14) << angle;
    EXPECT_NEAR(motion.turn.z(), angle, 1e-15);
  }
}

TEST(ScrewMotion, arcHeight_isAnEighthOfTheAcceleration) {
  // Radius 1 at pi / 2 a unit of time: the middle of the arc is 1 - cos(45 deg) = 0.293 from its
  // chord; the bound is (pi / 2)^2 / 8 = 0.308.
  EXPECT_NEAR(arcHeight(quarterTurn(), Vector3d::Zero()), kPi * kPi / 32.0, kExact);
  EXPECT_NEAR(arcHeight(quarterTurn(), {1, 0, 5}), 0.0, kExact);
}

TEST(ScrewMotion, bodyOnALink_goesRoundWithIt) {
  const ScrewMotion body = carriedBy(quarterTurn(), at(3, 0, 0));
  expectNear(body.start.translation, {3, 0, 0}, "start");
  expectNear(body.travel, {0, kPi, 4}, "velocity of its origin");
  expectNear(poseAt(body, 1.0).translation, {1, 2, 4}, "end");
}

TEST(ScrewMotion, straightMotion_sweptBoxIsThatOfBothEnds) {
  const Aabb box =
      sweptAabbOf(Sphere{0.5}, screwBetween(at(1, 2, 3), at(4, 2, 1)), at(4, 2, 1), 0.25);
  expectNear(box.min, {0.25, 1.25, 0.25}, "least corner");
  expectNear(box.max, {4.75, 2.75, 3.75}, "greatest corner");
}

}  // namespace
}  // namespace collision_monitor::test
