// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

TEST(CapsuleCapsule, crossedAtADistance_normalIsTheCrossProduct) {
  const Pose along_x{zToX(), {0, 3, 0}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 1.0}, along_x);
  expectDistance(found, 1.5, {0, 1, 0}, {0, 0.5, 0});
}

TEST(CapsuleCapsule, endOverMiddle_distanceIsToTheEnd) {
  const Pose along_x{zToX(), {3, 0, 0.5}};  // its end at x = 2
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.5}, along_x);
  expectDistance(found, 1.0, {1, 0, 0}, {0.5, 0, 0.5});
}

TEST(CapsuleCapsule, endToEnd_distanceIsBetweenCaps) {
  const Pose along_x{zToX(), {4, 0, 5}};  // ends (0,0,1) and (3,0,5)
  const auto found = distanceBetween(Capsule{1.0, 1.0}, Pose{}, Capsule{1.0, 1.0}, along_x);
  expectDistance(found, 3.0, {0.6, 0, 0.8}, {0.6, 0, 1.8});
}

TEST(CapsuleCapsule, parallelSideBySide_pointsLieInTheMiddleOfTheSharedStretch) {
  // z from -1 to 1 and from 0.5 to 2.5 share 0.5 to 1.
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.5}, at(2, 0, 1.5));
  expectDistance(found, 1.0, {1, 0, 0}, {0.5, 0, 0.75});
}

TEST(CapsuleCapsule, antiparallelSideBySide_pointsLieInTheMiddleToo) {
  const Pose down{axes(Vector3d::UnitX(), -Vector3d::UnitY()), {2, 0, 1.5}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.5}, down);
  expectDistance(found, 1.0, {1, 0, 0}, {0.5, 0, 0.75});
}

TEST(CapsuleCapsule, collinearApart_distanceIsBetweenTheEnds) {
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.5}, at(0, 0, 5));
  expectDistance(found, 2.0, {0, 0, 1}, {0, 0, 1.5});
}

TEST(CapsuleCapsule, axesCrossInOnePoint_depthIsSumOfRadiiAcrossBoth) {
  const Pose along_x{zToX(), {0.25, 0, 0.25}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.25}, along_x);
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.y()), 1.0, kExact);
  EXPECT_NEAR(found.point_on_a.z(), 0.25, kExact);
  expectConsistent(found);
}

TEST(CapsuleCapsule, endOnTheOthersAxis_depthIsSumOfRadiiAcrossBoth) {
  const Pose along_x{zToX(), {1, 0, 0}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.25}, along_x);
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(found.normal_a_to_b.z(), 0.0, kExact);
  expectConsistent(found);
}

TEST(CapsuleCapsule, identical_depthIsSumOfRadii) {
  const Pose pose{eighthTurn() * zToX(), {1, 2, 3}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, pose, Capsule{1.0, 0.5}, pose);
  EXPECT_NEAR(found.distance, -1.0, kExact);
  EXPECT_NEAR(found.normal_a_to_b.dot(pose.rotation.col(2)), 0.0, kExact);
  expectConsistent(found);
}

TEST(CapsuleCapsule, collinearOverlapping_normalIsAcross) {
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, Capsule{1.0, 0.5}, at(0, 0, 1.5));
  EXPECT_NEAR(found.distance, -1.0, kExact);
  EXPECT_NEAR(found.normal_a_to_b.z(), 0.0, kExact);
  EXPECT_NEAR(found.point_on_a.z(), 0.75, kExact);
  expectConsistent(found);
}

TEST(CapsuleCapsule, bothOfZeroLength_isSphereSphere) {
  const auto found = distanceBetween(Capsule{0.0, 1.0}, Pose{}, Capsule{0.0, 2.0}, at(0, 3, 4));
  expectDistance(found, 2.0, {0, 0.6, 0.8}, {0, 0.6, 0.8});
}

// The textbook's denominator a e - b^2 is all rounding at this angle: it puts the points of these
// crossing segments anywhere, and the segments up to 1e-8 m apart.
TEST(CapsuleCapsule, crossingAtAnAngleOf1e8_distanceIsZero) {
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(1e-8, Vector3d::UnitX()).toRotationMatrix();
  for (const double crossing : {-0.9, -0.3, 0.0, 0.4, 0.8}) {
    const Pose through{turned, Vector3d(0, 0, crossing) - 0.1 * turned.col(2)};
    const auto found = distanceBetween(Capsule{1.0, 0.0}, Pose{}, Capsule{1.0, 0.0}, through);
    EXPECT_LE(found.distance, 1e-15) << "crossing at " << crossing;
  }
}

}  // namespace
}  // namespace collision_monitor::test
