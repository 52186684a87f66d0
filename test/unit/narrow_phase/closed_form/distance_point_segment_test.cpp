// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

TEST(SphereCapsule, besideTheMiddle_nearestIsAcross) {
  const auto found = distanceBetween(Sphere{0.5}, at(3, 0, 0.25), Capsule{1.0, 0.5}, Pose{});
  expectDistance(found, 2.0, {-1, 0, 0}, {2.5, 0, 0.25});
}

TEST(SphereCapsule, beyondTheEnd_nearestIsTheCap) {
  const auto found = distanceBetween(Sphere{0.5}, at(0, 3, 5), Capsule{1.0, 0.5}, Pose{});
  expectDistance(found, 4.0, {0, -0.6, -0.8}, {0, 2.7, 4.6});
}

TEST(SphereCapsule, beforeTheOtherEnd_nearestIsItsCap) {
  const auto found = distanceBetween(Sphere{0.0}, at(0, 0, -4), Capsule{1.0, 1.0}, Pose{});
  expectDistance(found, 2.0, {0, 0, 1}, {0, 0, -4});
}

TEST(SphereCapsule, centerOnTheAxis_normalIsAcross) {
  const auto found = distanceBetween(Sphere{0.5}, at(0, 0, 0.5), Capsule{1.0, 0.25}, Pose{});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(found.normal_a_to_b.z(), 0.0, kExact);
  expectConsistent(found);
}

TEST(SphereCapsule, centerOnTheEnd_depthIsSumOfRadii) {
  const auto found = distanceBetween(Sphere{0.5}, at(0, 0, 1), Capsule{1.0, 0.25}, Pose{});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  expectConsistent(found);
}

TEST(SphereCapsule, zeroLength_isSphereSphere) {
  const auto found = distanceBetween(Sphere{1.0}, at(0, 3, 4), Capsule{0.0, 2.0}, Pose{});
  expectDistance(found, 2.0, {0, -0.6, -0.8}, {0, 2.4, 3.2});
}

}  // namespace
}  // namespace collision_monitor::test
