// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const RoundedBox kBlock{{1.0, 2.0, 3.0}, 0.0};

TEST(CapsuleBox, endOverAFace_distanceIsToTheFace) {
  const auto found = distanceBetween(Capsule{1.0, 0.5}, at(0.5, 1, 6), kBlock, Pose{});
  expectDistance(found, 1.5, {0, 0, -1}, {0.5, 1, 4.5});
}

TEST(CapsuleBox, endTouchesFace_distanceIsZero) {
  const auto found = distanceBetween(Capsule{1.0, 0.5}, at(0.5, 1, 4.5), kBlock, Pose{});
  expectDistance(found, 0.0, {0, 0, -1}, {0.5, 1, 3});
}

TEST(CapsuleBox, parallelToAFace_pointsLieInTheMiddleOfTheSharedStretch) {
  const Pose along_x{zToX(), {1, 0, 5}};  // x from 0 to 2, of which 0 to 1 over the face
  const auto found = distanceBetween(Capsule{1.0, 0.5}, along_x, kBlock, Pose{});
  expectDistance(found, 1.5, {0, 0, -1}, {0.5, 0, 4.5});
}

TEST(CapsuleBox, spanningAFace_pointsLieOverItsMiddle) {
  const Pose along_x{zToX(), {0.5, 0, 5}};  // beyond the face on both sides
  const auto found = distanceBetween(Capsule{4.0, 0.5}, along_x, kBlock, Pose{});
  expectDistance(found, 1.5, {0, 0, -1}, {0, 0, 4.5});
}

TEST(CapsuleBox, parallelToAnEdge_distanceIsInThePlaneAcrossIt) {
  const auto found = distanceBetween(Capsule{1.0, 1.0}, at(4, 6, 2.5), kBlock, Pose{});
  expectDistance(found, 4.0, {-0.6, -0.8, 0}, {3.4, 5.2, 2.25});  // z from 1.5 to 3
}

TEST(CapsuleBox, crossingAnEdge_normalIsTheirCrossProduct) {
  // In the plane z = 0 the axis runs along (1, -1), which the edge at (1, 2) sees at a distance of
  // sqrt(2) when it passes through (2, 3).
  const double s = std::sqrt(0.5);
  const Pose slanted{axes({0, 0, 1}, {s, s, 0}), {2, 3, 0}};
  const auto found = distanceBetween(Capsule{1.0, 0.5}, slanted, kBlock, Pose{});
  expectDistance(found, std::sqrt(2.0) - 0.5, {-s, -s, 0}, {2 - 0.5 * s, 3 - 0.5 * s, 0});
}

TEST(CapsuleBox, endOffACorner_distanceIsToTheCorner) {
  const auto found = distanceBetween(Capsule{1.0, 1.0}, at(3, 4, 5), kBlock, Pose{});  // 2, 2, 1
  expectDistance(found, 2.0, {-2.0 / 3, -2.0 / 3, -1.0 / 3}, {7.0 / 3, 10.0 / 3, 11.0 / 3});
}

TEST(CapsuleBox, axisPiercesBox_leavesAcrossTheAxis) {
  const Pose through{Eigen::Matrix3d::Identity(), {0.75, 0, 0}};  // longer than the box
  const auto found = distanceBetween(Capsule{5.0, 0.5}, through, kBlock, Pose{});
  expectDistance(found, -0.75, {-1, 0, 0}, {0.25, 0, 0});
}

TEST(CapsuleBox, endInside_leavesByTheFaceItCameThrough) {
  const Pose inserted{zToX(), {1.75, 0, 0}};  // the end at x = 0.75
  const auto found = distanceBetween(Capsule{1.0, 0.5}, inserted, kBlock, Pose{});
  expectDistance(found, -0.75, {-1, 0, 0}, {0.25, 0, 0});
}

TEST(CapsuleBox, slantedAcrossAnEdge_leavesPerpendicularToBoth) {
  // As crossingAnEdge, but the axis cuts the corner of the cross section 0.25 sqrt(2) deep.
  const double s = std::sqrt(0.5);
  const Pose slanted{axes({0, 0, 1}, {s, s, 0}), {0.75, 1.75, 0}};
  const auto found = distanceBetween(Capsule{2.0, 0.5}, slanted, kBlock, Pose{});
  const double deep = 0.25 * std::sqrt(2.0);
  EXPECT_NEAR(found.distance, -deep - 0.5, kExact);
  expectNear(found.normal_a_to_b, {-s, -s, 0}, "normal");
  expectConsistent(found);
}

TEST(CapsuleBox, concentricAlongTheLongestSide_depthIsTheThinnest) {
  const auto found = distanceBetween(Capsule{1.0, 0.5}, Pose{}, kBlock, Pose{});
  EXPECT_NEAR(found.distance, -1.5, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.x()), 1.0, kExact);
  expectConsistent(found);
}

TEST(CapsuleBox, axisLiesInARectangle_depthIsSumOfRadii) {
  const Pose along_x{zToX(), {0, 0, 0}};
  const auto found =
      distanceBetween(Capsule{0.5, 0.25}, along_x, RoundedBox{{1, 1, 0}, 0.5}, Pose{});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.z()), 1.0, kExact);
  expectConsistent(found);
}

TEST(CapsuleBox, boxThatIsASegment_isCapsuleCapsule) {
  const Pose along_x{zToX(), {0, 3, 0}};
  const auto found =
      distanceBetween(Capsule{1.0, 0.5}, along_x, RoundedBox{{0, 0, 1}, 1.0}, Pose{});
  expectDistance(found, 1.5, {0, -1, 0}, {0, 2.5, 0});
}

TEST(CapsuleBox, allExtentsZero_isSphereSphere) {
  const auto found =
      distanceBetween(Capsule{0.0, 1.0}, at(0, 3, 4), RoundedBox{{0, 0, 0}, 2.0}, Pose{});
  expectDistance(found, 2.0, {0, -0.6, -0.8}, {0, 2.4, 3.2});
}

}  // namespace
}  // namespace collision_monitor::test
