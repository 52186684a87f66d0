// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

TEST(SphereSphere, apartAlongX_gapIsOffsetLessRadii) {
  const auto found = distanceBetween(Sphere{1.0}, at(0, 0, 0), Sphere{0.5}, at(4, 0, 0));
  expectDistance(found, 2.5, {1, 0, 0}, {1, 0, 0});
}

TEST(SphereSphere, pythagoreanOffset_normalIsOffsetOverLength) {
  const auto found = distanceBetween(Sphere{1.0}, at(0, 0, 0), Sphere{2.0}, at(0, 3, 4));
  expectDistance(found, 2.0, {0, 0.6, 0.8}, {0, 0.6, 0.8});
}

TEST(SphereSphere, overlapping_depthIsRadiiLessOffset) {
  const auto found = distanceBetween(Sphere{1.0}, at(0, 0, 0), Sphere{1.0}, at(0, 0, -1.5));
  expectDistance(found, -0.5, {0, 0, -1}, {0, 0, -1});
}

TEST(SphereSphere, concentric_depthIsSumOfRadii) {
  const auto found = distanceBetween(Sphere{1.0}, at(2, 3, 4), Sphere{0.25}, at(2, 3, 4));
  EXPECT_NEAR(found.distance, -1.25, kExact);
  expectConsistent(found);
}

TEST(SphereSphere, twoPointsAtOnePlace_distanceIsZero) {
  const auto found = distanceBetween(Sphere{0.0}, at(1, 1, 1), Sphere{0.0}, at(1, 1, 1));
  EXPECT_EQ(found.distance, 0.0);
  expectConsistent(found);
}

}  // namespace
}  // namespace collision_monitor::test
