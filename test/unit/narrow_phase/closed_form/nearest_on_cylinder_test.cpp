// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/nearest_on_cylinder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d kCan(1.0, 1.0, 1.0);  // radius and half length 1

void expectFoot(const ClosestOnCylinder& closest, const Vector3d& on_cylinder,
                const Vector3d& away) {
  expectNear(closest.on_cylinder, on_cylinder, "on the cylinder");
  expectNear(closest.away, away, "away");
}

TEST(NearestOnCylinder, footOfAPoint_isOnTheSideTheCapOrTheRim) {
  expectFoot(closestOf({3, 0, 0.5}, kCan), {1, 0, 0.5}, {2, 0, 0});
  expectFoot(closestOf({0.2, 0.3, -4}, kCan), {0.2, 0.3, -1}, {0, 0, -3});
  expectFoot(closestOf({0, 4, 5}, kCan), {0, 1, 1}, {0, 3, 4});
  expectFoot(closestOf({0.1, 0.2, 0.3}, kCan), {0.1, 0.2, 0.3}, {0, 0, 0});
}

TEST(NearestOnCylinder, footOfAnEdge_isWhereItIsNearest) {
  double share = 0.9;
  expectFoot(closestToEdge({3, -1, 0}, {0, 4, 0}, kCan, share), {1, 0, 0}, {2, 0, 0});
  EXPECT_NEAR(share, 0.25, 1e-12);
  share = 0.0;
  expectFoot(closestToEdge({2, -3, 2}, {0, 5, 0}, kCan, share), {1, 0, 1}, {1, 0, 1});
  EXPECT_NEAR(share, 0.6, 1e-12);
}

TEST(NearestOnCylinder, edgeThatLeadsAway_isNearestAtItsEnd) {
  double share = 0.7;
  expectFoot(closestToEdge({3, 0, 0}, {1, 2, 0}, kCan, share), {1, 0, 0}, {2, 0, 0});
  EXPECT_EQ(share, 0.0);
}

// Crosses from over the cap to beside the side on its way.
TEST(NearestOnCylinder, slantedEdge_standsSquareOnItsWayOut) {
  const Vector3d from(-0.5, 0.3, 1.8);
  const Vector3d edge(3.0, 0.2, -1.0);
  double share = 0.0;
  const ClosestOnCylinder closest = closestToEdge(from, edge, kCan, share);
  EXPECT_NEAR(closest.away.dot(edge), 0.0, 1e-12);
  expectNear(closest.on_cylinder + closest.away, from + share * edge, "on the edge");
  EXPECT_GT(closest.away.norm(), 0.1);
}

TEST(NearestOnCylinder, footOfARim_isWhereItIsNearest) {
  Rim rim{{4, 0, 0}, Eigen::Matrix<double, 3, 2>::Zero()};
  rim.across.col(0) = Vector3d::UnitX();
  rim.across.col(1) = Vector3d::UnitZ();
  Vector2d turn(std::cos(2.5), std::sin(2.5));
  expectFoot(closestToRim(rim, kCan, turn), {1, 0, 0}, {2, 0, 0});
  EXPECT_NEAR(turn.x(), -1.0, 1e-12);
  EXPECT_NEAR(turn.y(), 0.0, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
