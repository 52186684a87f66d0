// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/link_velocity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

Pose turnedAboutZ(double angle, const Vector3d& translation) {
  return {Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(), translation};
}

void expectNear(const Vector3d& actual, const Vector3d& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-12) << actual.transpose();
}

TEST(Twist, velocityAt_turnsAboutItsAxis) {
  // 2 rad/s about z through (1, 0, 0), which itself rises at 5 m/s.
  const Twist twist = twistAbout({1, 0, 0}, {0, 0, 5}, {0, 0, 2});
  expectNear(velocityAt(twist, {1, 0, 0}), {0, 0, 5});
  expectNear(velocityAt(twist, {4, 0, 0}), {0, 6, 5});
  expectNear(velocityAt(twist, Vector3d::Zero()), twist.linear);
}

TEST(TwistBetween, straight) {
  const Twist twist =
      twistBetween(turnedAboutZ(0.3, {1, 2, 3}), turnedAboutZ(0.3, {1, 2.5, 3}), 0.1);
  expectNear(twist.angular, Vector3d::Zero());
  expectNear(velocityAt(twist, {7, 8, 9}), {0, 5, 0});
}

TEST(TwistBetween, turnAboutAFixedAxis_isExactHoweverFar) {
  // On a circle of radius 2 about the z axis, from angle 0.2 to 1.2 in half a second.
  const auto onCircle = [](double angle) {
    return turnedAboutZ(angle, {2 * std::cos(angle), 2 * std::sin(angle), 0});
  };
  const Twist twist = twistBetween(onCircle(0.2), onCircle(1.2), 0.5);
  expectNear(twist.angular, {0, 0, 2});
  expectNear(twist.linear, Vector3d::Zero());
  expectNear(velocityAt(twist, {2, 0, 0}), {0, 4, 0});
}

TEST(Smoothed, stepIsFollowed) {
  const Twist rest;
  const Twist step{{1, 0, 0}, {0, 2, 0}};
  const Twist after = smoothed(rest, step, smoothingShare(0.02, 0.02));
  expectNear(after.linear, {1 - std::exp(-1.0), 0, 0});
  expectNear(after.angular, {0, 2 - 2 * std::exp(-1.0), 0});
  // Two halves make a whole.
  const double of_half = smoothingShare(0.01, 0.02);
  const Twist halves = smoothed(smoothed(rest, step, of_half), step, of_half);
  expectNear(halves.linear, after.linear);
}

TEST(Smoothed, noTimeConstant_passesEverything) {
  const Twist step{{1, 0, 0}, {0, 2, 0}};
  expectNear(smoothed(Twist(), step, smoothingShare(0.001, 0.0)).linear, {1, 0, 0});
}

}  // namespace
}  // namespace collision_monitor
