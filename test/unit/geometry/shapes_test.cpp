// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

TEST(Volume, isThatOfTheTextbook) {
  EXPECT_NEAR(volumeOf(Sphere{2.0}), 4.0 / 3.0 * kPi * 8.0, 1e-12);
  EXPECT_NEAR(volumeOf(Capsule{1.5, 1.0}), kPi * 3.0 + 4.0 / 3.0 * kPi, 1e-12);
  EXPECT_NEAR(volumeOf(Box{{0.5, 1.0, 1.5}}), 6.0, 1e-12);
  // A unit cube swept by a ball of radius 1: 1 + 6 slabs + 12 quarter cylinders + 8 eighths.
  EXPECT_NEAR(volumeOf(RoundedBox{{0.5, 0.5, 0.5}, 1.0}), 7.0 + 3.0 * kPi + 4.0 / 3.0 * kPi, 1e-12);
}

TEST(SupportPoint, isTheFarthestPoint) {
  const Eigen::Vector3d up(0.0, 0.0, 2.0);
  EXPECT_EQ(supportPoint(Sphere{0.5}, up), Eigen::Vector3d(0, 0, 0.5));
  EXPECT_EQ(supportPoint(Capsule{1.0, 0.5}, -up), Eigen::Vector3d(0, 0, -1.5));
  EXPECT_EQ(supportPoint(Box{{1, 2, 3}}, {1.0, -1.0, 1.0}), Eigen::Vector3d(1, -2, 3));
  const double r = 0.5 / std::sqrt(3.0);
  EXPECT_TRUE(supportPoint(RoundedBox{{1, 2, 3}, 0.5}, {1.0, -1.0, 1.0})
                  .isApprox(Eigen::Vector3d(1 + r, -2 - r, 3 + r), 1e-15));
}

TEST(SupportPoint, zeroDirection_isAPointOfTheShape) {
  EXPECT_LE(signedDistanceTo(Capsule{1.0, 0.5}, supportPoint(Capsule{1.0, 0.5}, {0, 0, 0})), 0.0);
}

TEST(SignedDistanceToPoint, outsideOnAndInside) {
  EXPECT_DOUBLE_EQ(signedDistanceTo(Sphere{1.0}, {3.0, 0.0, 0.0}), 2.0);
  EXPECT_DOUBLE_EQ(signedDistanceTo(Sphere{1.0}, {0.0, 0.0, 0.0}), -1.0);
  EXPECT_DOUBLE_EQ(signedDistanceTo(Capsule{1.0, 0.5}, {0.0, 2.0, 0.5}), 1.5);
  EXPECT_DOUBLE_EQ(signedDistanceTo(Capsule{1.0, 0.5}, {0.0, 3.0, 5.0}), 4.5);  // 3-4-5
  EXPECT_DOUBLE_EQ(signedDistanceTo(Box{{1, 2, 3}}, {0.5, 0.0, 0.0}), -0.5);
  EXPECT_DOUBLE_EQ(signedDistanceTo(Box{{1, 2, 3}}, {4.0, 6.0, 0.0}), 5.0);  // 3-4-5
  EXPECT_DOUBLE_EQ(signedDistanceTo(RoundedBox{{1, 2, 3}, 0.5}, {0.0, 2.5, 0.0}), 0.0);
}

TEST(ZeroSizes, everyShapeMayBeAPoint) {
  for (const Shape& point :
       {Shape(Sphere{}), Shape(Capsule{}), Shape(Box{}), Shape(RoundedBox{})}) {
    EXPECT_EQ(volumeOf(point), 0.0) << kindName(point);
    EXPECT_EQ(supportPoint(point, {1, 2, 3}), Eigen::Vector3d::Zero()) << kindName(point);
    EXPECT_DOUBLE_EQ(signedDistanceTo(point, {0, 0, 2}), 2.0) << kindName(point);
  }
}

TEST(CoreKind, followsTheShape) {
  EXPECT_EQ(coreKindOf(Sphere{}), CoreKind::point);
  EXPECT_EQ(coreKindOf(Capsule{}), CoreKind::segment);
  EXPECT_EQ(coreKindOf(Box{}), CoreKind::box);
  EXPECT_EQ(coreKindOf(RoundedBox{}), CoreKind::box);
}

}  // namespace
}  // namespace collision_monitor
