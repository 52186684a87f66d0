// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/closing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A's point at x = 1, B's `distance` beyond it.
SignedDistance alongX(double distance) {
  return {distance, Vector3d(1, 0, 0), Vector3d(1 + distance, 0, 0), Vector3d::UnitX()};
}

Twist moving(const Vector3d& linear) { return {linear, Vector3d::Zero()}; }

TEST(DistanceRate, onlyWhatGoesAlongTheNormalCounts) {
  // B comes at 2 m/s and slips aside, A follows at 0.5 m/s.
  EXPECT_DOUBLE_EQ(distanceRate(alongX(0.3), moving({-0.5, 0, 9}), moving({-2, 7, 0})), -1.5);
  EXPECT_DOUBLE_EQ(distanceRate(alongX(0.3), moving({-2, 0, 0}), moving({-0.5, 0, 0})), 1.5);
}

TEST(DistanceRate, overlapping_partingMakesTheDistanceGrowToo) {
  EXPECT_DOUBLE_EQ(distanceRate(alongX(-0.1), Twist(), moving({2, 0, 0})), 2.0);
  EXPECT_DOUBLE_EQ(distanceRate(alongX(-0.1), Twist(), moving({-2, 0, 0})), -2.0);
}

TEST(DistanceRate, turningBody_movesByItsLever) {
  // A turns at 3 rad/s about z through (1, -2, 0): its point is 2 m ahead in y and goes to -x.
  const Twist turning = twistAbout({1, -2, 0}, Vector3d::Zero(), {0, 0, 3});
  EXPECT_DOUBLE_EQ(distanceRate(alongX(0.3), turning, Twist()), 6.0);
}

TEST(DistanceRate, bothMoveAsOne_nothingChanges) {
  const Twist shared{{1, 2, 3}, {4, 5, 6}};
  EXPECT_NEAR(distanceRate(alongX(0.3), shared, shared), 0.0, 1e-15);
}

TEST(TimeToContact, gapOverSpeed) {
  EXPECT_DOUBLE_EQ(timeToContact(0.012, 0.2, 1.0), 0.06);
  EXPECT_DOUBLE_EQ(timeToContact(0.2, 0.2, 1.0), 1.0) << "the horizon itself is within";
}

TEST(TimeToContact, beyondTheHorizonAndParting_isNever) {
  EXPECT_EQ(timeToContact(0.21, 0.2, 1.0), kInfinity);
  EXPECT_EQ(timeToContact(0.1, 0.0, 1.0), kInfinity);
  EXPECT_EQ(timeToContact(0.1, -3.0, 1.0), kInfinity);
  EXPECT_EQ(timeToContact(0.1, 1e9, 0.0), kInfinity);
}

TEST(TimeToContact, noGapLeft_isNow) {
  EXPECT_EQ(timeToContact(0.0, -1.0, 1.0), 0.0);
  EXPECT_EQ(timeToContact(-0.1, kNaN, 1.0), 0.0) << "what touches, touches, whatever its speed";
}

TEST(TimeToContact, notKnown_isNotKnown) {
  EXPECT_TRUE(std::isnan(timeToContact(0.1, kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(timeToContact(kNaN, 1.0, 1.0)));
}

}  // namespace
}  // namespace collision_monitor
