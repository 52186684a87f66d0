// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle/triangle_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const Triangle kFloor{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};

Triangle triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return {a, b, c}; }

void expectApart(const Triangle& a, const Triangle& b, const Vector3d& on_a, const Vector3d& on_b) {
  const PointPair found = nearestPoints(a, b);
  expectNear(found.on_a, on_a, "on a");
  expectNear(found.on_b, on_b, "on b");
  EXPECT_NEAR(std::sqrt(found.squared_distance), (on_b - on_a).norm(), kExact);
  EXPECT_FALSE(overlap(a, b));
  EXPECT_FALSE(overlap(b, a));
}

void expectOverlap(const Triangle& a, const Triangle& b) {
  EXPECT_TRUE(overlap(a, b));
  EXPECT_TRUE(overlap(b, a));
  EXPECT_LE(nearestPoints(a, b).squared_distance, 1e-28);
}

TEST(TriangleTriangle, cornerOverFace) {
  expectApart(kFloor, triangle({1, 1, 2}, {1, 2, 5}, {2, 1, 5}), {1, 1, 0}, {1, 1, 2});
}

TEST(TriangleTriangle, crossingEdges) {
  // The edge along y at x = 2 passes over the one along x at y = 0.
  expectApart(kFloor, triangle({2, -3, 1}, {2, 3, 1}, {2, 0, 9}), {2, 0, 0}, {2, 0, 1});
}

TEST(TriangleTriangle, cornerToCorner) {
  expectApart(kFloor, triangle({7, 0, 4}, {9, 0, 4}, {9, 1, 5}), {4, 0, 0}, {7, 0, 4});
}

TEST(TriangleTriangle, cornerToEdgeInOnePlane) {
  expectApart(kFloor, triangle({3, 3, 0}, {5, 4, 0}, {4, 5, 0}), {2, 2, 0}, {3, 3, 0});
}

TEST(TriangleTriangle, edgePassesThroughFace) {
  expectOverlap(kFloor, triangle({1, 1, -1}, {1, 1, 1}, {9, 9, 3}));
}

TEST(TriangleTriangle, facesCrossEachOther) {
  // Each has one edge that passes through the other.
  expectOverlap(kFloor, triangle({1, -1, -1}, {1, -1, 1}, {1, 2, 0}));
}

TEST(TriangleTriangle, planesCrossBesideTheTriangle_apart) {
  expectApart(kFloor, triangle({5, 0, -1}, {5, 0, 1}, {9, 0, 0}), {4, 0, 0}, {5, 0, 0});
}

TEST(TriangleTriangle, inOnePlane_crossingContainedAndSharingAnEdge) {
  expectOverlap(kFloor, triangle({1, -1, 0}, {1, 5, 0}, {2, -1, 0}));
  expectOverlap(kFloor, triangle({0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}));
  expectOverlap(kFloor, triangle({0, 0, 0}, {4, 0, 0}, {0, -4, 0}));
}

TEST(TriangleTriangle, touchingAtOnePoint_overlap) {
  expectOverlap(kFloor, triangle({1, 1, 0}, {1, 2, 3}, {2, 1, 3}));    // corner on face
  expectOverlap(kFloor, triangle({2, -1, 0}, {2, 1, 0}, {2, 0, -3}));  // edge in the plane
  expectOverlap(kFloor, triangle({4, 0, 0}, {5, 0, 1}, {5, 1, 0}));    // corner on corner
}

TEST(TriangleTriangle, nearlyTouching_apart) {
  expectApart(kFloor, triangle({1, 1, 1e-9}, {1, 2, 3}, {2, 1, 3}), {1, 1, 0}, {1, 1, 1e-9});
}

TEST(TriangleTriangle, segmentsAndPoints_standForWhatTheyCover) {
  const Triangle segment = triangle({1, 1, 1}, {1, 1, 3}, {1, 1, 2});
  const Triangle point = triangle({1, 1, -2}, {1, 1, -2}, {1, 1, -2});
  expectApart(kFloor, segment, {1, 1, 0}, {1, 1, 1});
  expectApart(kFloor, point, {1, 1, 0}, {1, 1, -2});
  expectApart(segment, point, {1, 1, 1}, {1, 1, -2});
  expectApart(point, triangle({2, 1, -2}, {2, 1, -2}, {2, 1, -2}), {1, 1, -2}, {2, 1, -2});
  expectOverlap(kFloor, triangle({1, 1, -1}, {1, 1, 3}, {1, 1, 2}));
  expectOverlap(point, point);
}

TEST(TriangleTriangle, needle_distanceToItsMiddle) {
  // A billionth of a metre wide, ten metres long.
  const Triangle needle = triangle({0, 0, 0}, {10, 0, 0}, {5, 1e-9, 0});
  expectApart(needle, triangle({5, 0.5e-9, 1}, {5, 0, 3}, {6, 0, 3}), {5, 0.5e-9, 0},
              {5, 0.5e-9, 1});
}

TEST(TriangleTriangle, pointsAreNotLookedForBeyondTheStart) {
  PointPair start;
  start.squared_distance = 3.9;
  const PointPair found = nearestPoints(kFloor, triangle({1, 1, 2}, {1, 2, 5}, {2, 1, 5}), start);
  EXPECT_EQ(found.squared_distance, 3.9);
  EXPECT_EQ(found.on_a, start.on_a);
}

}  // namespace
}  // namespace collision_monitor::test
