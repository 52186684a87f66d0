// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

RoundedBox box(double x, double y, double z, double radius = 0.0) { return {{x, y, z}, radius}; }

TEST(BoxBox, facesSideBySide_pointsLieInTheMiddleOfTheSharedPatch) {
  // y from -1 to 1 and from 0.5 to 2.5 share 0.5 to 1; z from -1 to 1 and -3 to -0.5 share -1 to
  // -0.5.
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1.25), at(4, 1.5, -1.75));
  expectDistance(found, 2.0, {1, 0, 0}, {1, 0.75, -0.75});
}

TEST(BoxBox, plankAcrossPlank_patchHasNoCornerOfEither) {
  const auto found = distanceBetween(box(5, 0.5, 0.5), Pose{}, box(0.25, 5, 0.5), at(1, 2, 1.5));
  expectDistance(found, 0.5, {0, 0, 1}, {1, 0, 0.5});
}

TEST(BoxBox, turnedFaceOverFace_patchCenterIsTheCommonCenter) {
  const Pose turned{eighthTurn(), {0, 0, 3}};
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), turned);
  expectDistance(found, 1.0, {0, 0, 1}, {0, 0, 1});
}

TEST(BoxBox, parallelEdges_pointsLieInTheMiddleOfTheSharedStretch) {
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), at(5, 6, 1.5));
  expectDistance(found, 5.0, {0.6, 0.8, 0}, {1, 1, 0.75});
}

TEST(BoxBox, cornersFaceEachOther_distanceIsBetweenThem) {
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), at(4, 4, 3));  // 2, 2, 1
  expectDistance(found, 3.0, {2.0 / 3, 2.0 / 3, 1.0 / 3}, {1, 1, 1});
}

TEST(BoxBox, cornerOverFace_distanceIsToThePlane) {
  // A cube on its corner: the half diagonal sqrt(3) hangs down.
  const double s3 = std::sqrt(1.0 / 3);
  const double s2 = std::sqrt(0.5);
  const Eigen::Matrix3d upright =
      axes({s2, -s2, 0}, Vector3d(s3, s3, s3).cross(Vector3d(s2, -s2, 0)));
  const Pose on_corner{upright.transpose(), {0.25, 0.5, 5}};
  const auto found = distanceBetween(box(2, 2, 1), Pose{}, box(1, 1, 1), on_corner);
  expectDistance(found, 4.0 - std::sqrt(3.0), {0, 0, 1}, {0.25, 0.5, 1});
}

TEST(BoxBox, crossedEdges_normalIsTheirCrossProduct) {
  // A lies on an edge along x, B hangs from one along y: the edges are 4 - 2 sqrt(2) apart.
  const double s = std::sqrt(0.5);
  const Pose roof{axes({1, 0, 0}, {0, s, s}), {0, 0, 0}};
  const Pose keel{axes({s, 0, s}, {0, 1, 0}), {0.5, 0.25, 4}};
  const auto found = distanceBetween(box(3, 1, 1), roof, box(1, 3, 1), keel);
  expectDistance(found, 4.0 - 2.0 * std::sqrt(2.0), {0, 0, 1}, {0.5, 0, std::sqrt(2.0)});
}

TEST(BoxBox, rotationsOfLongChains_measureAsThoseTheyStandFor) {
  // Products of many rotations are off by more than one: here by 1e-12, sheared and longer.
  Eigen::Matrix3d off = Eigen::Matrix3d::Identity();
  off += (Eigen::Matrix3d() << 3, 13, 13, 3, 13, 3, 3, 13, 3).finished() * 1e-13;
  for (const double angle : {0.3, 0.7, 1.1, 1.9, 2.6}) {
    const Eigen::Matrix3d roof = Eigen::AngleAxisd(0.25 * M_PI, Vector3d::UnitX()).matrix();
    const Eigen::Matrix3d keel = (Eigen::AngleAxisd(angle, Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(0.25 * M_PI, Vector3d::UnitX()))
                                     .matrix();
    const Pose above{keel * off, {0.1, 0.2, 4}};
    const auto found = distanceBetween(box(3, 1, 1), {roof * off, {0, 0, 0}}, box(3, 1, 1), above);
    EXPECT_NEAR(found.distance, 4.0 - 2.0 * std::sqrt(2.0), 1e-10) << angle;
  }
}

TEST(BoxBox, crossedEdgesOverlapping_depthIsBetweenTheEdges) {
  const double s = std::sqrt(0.5);
  const Pose roof{axes({1, 0, 0}, {0, s, s}), {0, 0, 0}};
  const Pose keel{axes({s, 0, s}, {0, 1, 0}), {0.5, 0.25, 2.5}};
  const auto found = distanceBetween(box(3, 1, 1), roof, box(1, 3, 1), keel);
  expectDistance(found, 2.5 - 2.0 * std::sqrt(2.0), {0, 0, 1}, {0.5, 0, std::sqrt(2.0)});
}

TEST(BoxBox, facesTouch_distanceIsZero) {
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), at(0, -2, 0.5));
  expectDistance(found, 0.0, {0, -1, 0}, {0, -1, 0.25});
}

TEST(BoxBox, cornersTouch_distanceIsZero) {
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), at(2, 2, 2));
  EXPECT_NEAR(found.distance, 0.0, kExact);
  expectNear(found.point_on_a, {1, 1, 1}, "point on a");
  expectConsistent(found);
}

TEST(BoxBox, slightOverlap_leavesByTheFace) {
  const auto found = distanceBetween(box(1, 1, 1), Pose{}, box(1, 1, 1), at(1.75, 0.5, 0));
  expectDistance(found, -0.25, {1, 0, 0}, {1, 0.25, 0});
}

TEST(BoxBox, smallInsideLarge_leavesByTheNearestFace) {
  const auto found = distanceBetween(box(3, 3, 3), Pose{}, box(0.5, 0.5, 0.5), at(0, 0, -2));
  expectDistance(found, -1.5, {0, 0, -1}, {0, 0, -3});
}

TEST(BoxBox, identical_depthIsTheThinnestSideTwice) {
  const Pose pose{eighthTurn(), {1, 2, 3}};
  const auto found = distanceBetween(box(1, 2, 0.5), pose, box(1, 2, 0.5), pose);
  EXPECT_NEAR(found.distance, -1.0, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.z()), 1.0, kExact);
  expectConsistent(found);
}

TEST(BoxBox, rounded_radiiCountOnBothSides) {
  const auto found = distanceBetween(box(1, 1, 1, 0.5), Pose{}, box(1, 1, 1, 1.0), at(5, 6, 0));
  expectDistance(found, 3.5, {0.6, 0.8, 0}, {1.3, 1.4, 0});
}

TEST(BoxBox, roundedCoresOverlap_depthAddsTheRadii) {
  const auto found = distanceBetween(box(1, 1, 1, 0.5), Pose{}, box(1, 1, 1, 1.0), at(1.5, 0, 0));
  expectDistance(found, -2.0, {1, 0, 0}, {1.5, 0, 0});
}

TEST(BoxBox, rectanglesThatCross_depthIsTheLeastWayOut) {
  // In the planes z = 0 and x = 0.75: B leaves A beyond x = 1.
  const auto found = distanceBetween(box(1, 1, 0), Pose{}, box(0, 1, 1), at(0.75, 0, 0));
  expectDistance(found, -0.25, {1, 0, 0}, {1, 0, 0});
}

TEST(BoxBox, rectanglesInOnePlane_depthIsZero) {
  const auto found = distanceBetween(box(1, 1, 0), Pose{}, box(1, 1, 0), at(0.5, 0.5, 0));
  EXPECT_NEAR(found.distance, 0.0, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.z()), 1.0, kExact);
  expectConsistent(found);
}

TEST(BoxBox, twoPointsAtOnePlace_distanceIsZero) {
  const auto found = distanceBetween(box(0, 0, 0), at(1, 2, 3), box(0, 0, 0), at(1, 2, 3));
  EXPECT_NEAR(found.distance, 0.0, kExact);
  expectConsistent(found);
}

TEST(BoxBox, needlesThatMiss_distanceIsBetweenTheirEdges) {
  const Pose along_y{zToY(), {0, 0, 0.01}};
  const auto found = distanceBetween(box(5, 1e-3, 1e-3), Pose{}, box(1e-3, 1e-3, 5), along_y);
  expectDistance(found, 0.008, {0, 0, 1}, {0, 0, 1e-3});
}

}  // namespace
}  // namespace collision_monitor::test
