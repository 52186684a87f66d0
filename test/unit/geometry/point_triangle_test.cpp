// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/point_triangle.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

const Vector3d kA(0, 0, 0);
const Vector3d kB(2, 0, 0);
const Vector3d kC(0, 2, 0);

Vector3d closest(const Vector3d& point) { return closestPointOnTriangle(point, kA, kB, kC); }

TEST(PointTriangle, aboveTheInside_givesTheFoot) {
  EXPECT_TRUE(closest({0.5, 0.5, 3.0}).isApprox(Vector3d(0.5, 0.5, 0.0), 1e-14));
  EXPECT_TRUE(closest({0.5, 0.5, -3.0}).isApprox(Vector3d(0.5, 0.5, 0.0), 1e-14));
}

TEST(PointTriangle, beyondACorner_givesTheCorner) {
  EXPECT_EQ(closest({-1, -1, 1}), kA);
  EXPECT_EQ(closest({4, -1, 1}), kB);
  EXPECT_EQ(closest({-1, 4, 1}), kC);
}

TEST(PointTriangle, beyondAnEdge_givesAPointOfTheEdge) {
  EXPECT_TRUE(closest({1, -2, 1}).isApprox(Vector3d(1, 0, 0), 1e-14));
  EXPECT_TRUE(closest({-2, 1, 1}).isApprox(Vector3d(0, 1, 0), 1e-14));
  EXPECT_TRUE(closest({2, 2, 1}).isApprox(Vector3d(1, 1, 0), 1e-14));
}

TEST(PointTriangle, orientation_makesNoDifference) {
  for (const Vector3d& point : {Vector3d(0.5, 0.5, 1), Vector3d(3, 1, 1), Vector3d(-1, 0.5, 2)}) {
    EXPECT_TRUE(closestPointOnTriangle(point, kA, kC, kB).isApprox(closest(point), 1e-14));
  }
}

TEST(PointTriangle, withoutArea_isItsLongestEdge) {
  const Vector3d point(1.5, 1.0, 0.0);
  EXPECT_TRUE(
      closestPointOnTriangle(point, kA, {1, 0, 0}, kB).isApprox(Vector3d(1.5, 0, 0), 1e-14));
  EXPECT_EQ(closestPointOnTriangle(point, kB, kB, kB), kB);
}

TEST(PointTriangle, needle_isNotMissed) {
  // Height 1e-13 of the length: its normal is mostly rounding.
  const Vector3d tip(1.0, 1e-13, 0.0);
  const Vector3d found = closestPointOnTriangle({1.0, 1.0, 1.0}, kA, kB, tip);
  EXPECT_NEAR((found - Vector3d(1.0, 0.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST(PointTriangle, obtuseTriangle_beyondTwoEdges_takesTheNearer) {
  // Beyond the edges at the far corner b of a triangle that is obtuse in a.
  const Vector3d b(4, 0, 0);
  const Vector3d c(-3, 1, 0);
  EXPECT_EQ(closestPointOnTriangle({4.5, 0.1, 1}, kA, b, c), b);
  EXPECT_TRUE(closestPointOnTriangle({0.5, 2.5, 0}, kA, b, c)
                  .isApprox(closestPointOnSegment({0.5, 2.5, 0}, b, c), 1e-14));
  EXPECT_EQ(closestPointOnTriangle({-0.2, -1, 0}, kA, b, c), kA);
}

TEST(PointSegment, threeCases) {
  EXPECT_EQ(closestPointOnSegment({-1, 1, 0}, kA, kB), kA);
  EXPECT_EQ(closestPointOnSegment({3, 1, 0}, kA, kB), kB);
  EXPECT_EQ(closestPointOnSegment({0.5, 1, 0}, kA, kB), Vector3d(0.5, 0, 0));
  EXPECT_EQ(closestPointOnSegment({0.5, 1, 0}, kB, kB), kB);
}

}  // namespace
}  // namespace collision_monitor
