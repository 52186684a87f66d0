// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/twist.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

TEST(Twist, bodyThatTurnsAboutAPoint_leavesThePointAlone) {
  const Twist twist = twistAbout({1, 2, 3}, Vector3d::Zero(), {0, 0, 2});
  EXPECT_EQ(velocityAt(twist, {1, 2, 3}), Vector3d::Zero());
  EXPECT_EQ(velocityAt(twist, {2, 2, 5}), Vector3d(0, 2, 0));
}

TEST(Wrench, powerOfAForce_isForceTimesVelocityOfItsPoint) {
  const Twist twist = twistAbout({1, 2, 3}, {0.5, -1, 2}, {0.25, 4, -2});
  const Vector3d point(-2, 1, 0.5);
  const Vector3d force(3, -1, 0.5);
  EXPECT_DOUBLE_EQ(power(forceAt(point, force), twist), force.dot(velocityAt(twist, point)));
  EXPECT_DOUBLE_EQ(power(-forceAt(point, force), twist), -force.dot(velocityAt(twist, point)));
}

}  // namespace
}  // namespace collision_monitor
