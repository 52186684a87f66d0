// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/segment_clearance.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
const TriangleBvh::Triangle kTriangle{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 0, 0),
                                      Eigen::Vector3d(0, 4, 0)};

double clearance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return clearanceBound(kTriangle, a, b, kFar);
}

void expectJustBelow(double bound, double distance) {
  EXPECT_LE(bound, distance);
  EXPECT_NEAR(bound, distance, 1e-12);
}

TEST(SegmentClearance, nearestInTheMiddleOfBoth_isFound) {
  // Above the edge on the x axis, crossing it at a right angle, lowest at y = -1: (1, -1, 1).
  expectJustBelow(clearance({1, -1, 3}, {1, -1, -3}), 1.0);
  expectJustBelow(clearance({1, -3, 0}, {1, -1, 2}), std::sqrt(2.0) * 1.5);
}

TEST(SegmentClearance, parallelToTheFace_isItsHeight) {
  expectJustBelow(clearance({0.5, 0.5, 2}, {1, 1, 2}), 2.0);
  expectJustBelow(clearance({-9, 1, 2}, {9, 1, 2}), 2.0);
}

TEST(SegmentClearance, endIsNearest) {
  expectJustBelow(clearance({1, 1, 1}, {1, 1, 5}), 1.0);
  expectJustBelow(clearance({-3, 0, 0}, {-5, 1, 0}), 3.0);
}

TEST(SegmentClearance, crossingOrTouching_isZero) {
  EXPECT_EQ(clearance({1, 1, -1}, {1, 1, 1}), 0.0);
  EXPECT_EQ(clearance({1, 1, 0}, {1, 1, 1}), 0.0);
  EXPECT_EQ(clearance({0, 0, 0}, {0, 0, 0}), 0.0);
}

TEST(SegmentClearance, point_isItsDistance) {
  expectJustBelow(clearance({1, 1, 2}, {1, 1, 2}), 2.0);
}

TEST(SegmentClearance, enough_mayEndTheSearchEarly) {
  EXPECT_GE(clearanceBound(kTriangle, {1, -1, 3}, {1, -1, -3}, 0.5), 0.5);
}

TEST(SegmentClearance, mesh_isItsNearestTriangle) {
  const TriangleBvh box(test::boxMesh({1, 2, 3}));
  expectJustBelow(clearanceBound(box, {0, 0, -2.5}, {0, 0, 2}), 0.5);
  expectJustBelow(clearanceBound(box, {0, -1.5, -1}, {0.25, 1.25, 1}), 0.5);
  expectJustBelow(clearanceBound(box, {4, 2, -3}, {4, -9, 3}), 3.0);
  EXPECT_EQ(clearanceBound(box, {0, 0, 0}, {9, 9, 9}), 0.0);
}

}  // namespace
}  // namespace collision_monitor
