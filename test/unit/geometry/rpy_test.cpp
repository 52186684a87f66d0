// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rpy.h"

#include <gtest/gtest.h>

#include "support/random_poses.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kQuarter = 1.57079632679489661923;

TEST(Rpy, quarterTurns_takeAxesToAxes) {
  EXPECT_TRUE((rotationOfRpy({kQuarter, 0, 0}) * Vector3d::UnitY()).isApprox(Vector3d::UnitZ()));
  EXPECT_TRUE((rotationOfRpy({0, kQuarter, 0}) * Vector3d::UnitZ()).isApprox(Vector3d::UnitX()));
  EXPECT_TRUE((rotationOfRpy({0, 0, kQuarter}) * Vector3d::UnitX()).isApprox(Vector3d::UnitY()));
}

TEST(Rpy, rollComesFirst_yawLast) {
  // Roll takes y to z, which yaw leaves alone; the other way round it would end at x.
  EXPECT_TRUE(
      (rotationOfRpy({kQuarter, 0, kQuarter}) * Vector3d::UnitY()).isApprox(Vector3d::UnitZ()));
}

TEST(Rpy, ofARotation_areTheAnglesItWasMadeOf) {
  const Vector3d rpy(0.3, -0.4, 2.5);
  EXPECT_TRUE(rpyOf(rotationOfRpy(rpy)).isApprox(rpy, 1e-14));
}

TEST(Rpy, uprightPitch_leavesAllToYaw) {
  Matrix3d upright;
  upright << 0.0, 0.6, 0.8, 0.0, 0.8, -0.6, -1.0, 0.0, 0.0;
  const Vector3d rpy = rpyOf(upright);
  EXPECT_EQ(rpy.x(), 0.0);
  EXPECT_NEAR(rpy.y(), kQuarter, 1e-15);
  EXPECT_TRUE(rotationOfRpy(rpy).isApprox(upright, 1e-15));
}

TEST(Rpy, everyRotation_isGivenBack) {
  test::Random random(11);
  for (int round = 0; round < 1000; ++round) {
    const Matrix3d rotation = test::randomRotation(random);
    EXPECT_TRUE(rotationOfRpy(rpyOf(rotation)).isApprox(rotation, 1e-12)) << round;
  }
}

}  // namespace
}  // namespace collision_monitor
