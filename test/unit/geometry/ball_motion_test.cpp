// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/ball_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

TEST(MotionOfBall, shiftOnly_isTheShift) {
  const Pose to{Eigen::Matrix3d::Identity(), {0.3, 0.0, 0.4}};
  EXPECT_NEAR(motionOfBall({1, 2, 3}, 5.0, Pose{}, to), 0.5, 1e-15);
}

TEST(MotionOfBall, quarterTurn_isWayOfTheCenterAndChordOfTheRadius) {
  const Pose to{Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()).toRotationMatrix(), {0, 0, 0}};
  // The center goes from (1, 0, 0) to (0, 1, 0), the ball turns by a chord of radius sqrt(2).
  EXPECT_NEAR(motionOfBall({1, 0, 0}, 0.5, Pose{}, to), 1.5 * std::sqrt(2.0), 1e-15);
}

TEST(MotionOfBall, halfTurn_takesPointsAcross) {
  const Pose to{Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix(), {0, 0, 0}};
  EXPECT_NEAR(motionOfBall({0, 0, 0}, 0.5, Pose{}, to), 1.0, 1e-15);
}

TEST(MotionOfBall, samePose_isNothing) {
  const Pose pose{Eigen::AngleAxisd(0.7, Vector3d::UnitY()).toRotationMatrix(), {1, 2, 3}};
  EXPECT_EQ(motionOfBall({4, 5, 6}, 7.0, pose, pose), 0.0);
}

}  // namespace
}  // namespace collision_monitor
