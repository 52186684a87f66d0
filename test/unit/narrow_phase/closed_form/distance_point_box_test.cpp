// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const RoundedBox kBox{{1.0, 2.0, 3.0}, 0.0};

TEST(SphereBox, aboveAFace_nearestIsTheFoot) {
  const auto found = distanceBetween(Sphere{0.5}, at(0.5, 1, 5), kBox, Pose{});
  expectDistance(found, 1.5, {0, 0, -1}, {0.5, 1, 4.5});
}

TEST(SphereBox, besideAnEdge_distanceIsInThePlaneAcrossIt) {
  const auto found = distanceBetween(Sphere{1.0}, at(4, 6, -1), kBox, Pose{});
  expectDistance(found, 4.0, {-0.6, -0.8, 0}, {3.4, 5.2, -1});
}

TEST(SphereBox, offACorner_distanceIsToTheCorner) {
  const auto found = distanceBetween(Sphere{1.0}, at(-3, -4, -4), kBox, Pose{});  // 2, 2, 1 beyond
  expectDistance(found, 2.0, {2.0 / 3, 2.0 / 3, 1.0 / 3}, {-7.0 / 3, -10.0 / 3, -11.0 / 3});
}

TEST(SphereBox, centerInside_leavesByTheNearestFace) {
  const auto found = distanceBetween(Sphere{0.5}, at(0.5, -1.75, 0), kBox, Pose{});
  expectDistance(found, -0.75, {0, 1, 0}, {0.5, -1.25, 0});
}

TEST(SphereBox, centerOnAFace_depthIsTheRadius) {
  const auto found = distanceBetween(Sphere{0.5}, at(1, 0, 0), kBox, Pose{});
  expectDistance(found, -0.5, {-1, 0, 0}, {0.5, 0, 0});
}

TEST(SphereBox, concentric_leavesByTheThinnestSide) {
  const auto found = distanceBetween(Sphere{0.5}, Pose{}, kBox, Pose{});
  EXPECT_NEAR(found.distance, -1.5, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.x()), 1.0, kExact);
  expectConsistent(found);
}

TEST(SphereBox, rectangle_sphereOnItSinksByItsRadius) {
  const auto found =
      distanceBetween(Sphere{0.5}, at(0.5, 0.5, 0), RoundedBox{{1, 1, 0}, 0.25}, Pose{});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.z()), 1.0, kExact);
  expectConsistent(found);
}

TEST(SphereBox, rounded_radiusCountsBeyondTheCore) {
  const auto found = distanceBetween(Sphere{1.0}, at(4, 6, 0), RoundedBox{{1, 2, 3}, 2.0}, Pose{});
  expectDistance(found, 2.0, {-0.6, -0.8, 0}, {3.4, 5.2, 0});
}

TEST(SphereBox, turnedBox_distanceIsAlongItsOwnAxis) {
  const Pose turned{eighthTurn(), {0, 0, 0}};
  const auto found = distanceBetween(Sphere{0.0}, at(3, 3, 0), kBox, turned);
  const double s = std::sqrt(0.5);
  expectDistance(found, 3.0 * std::sqrt(2.0) - 1.0, {-s, -s, 0}, {3, 3, 0});
}

}  // namespace
}  // namespace collision_monitor::test
