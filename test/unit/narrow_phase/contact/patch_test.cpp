// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/patch.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

using Eigen::Vector2d;

const Vector2d kSquare(1.0, 1.0);
constexpr double kTolerance = 1e-12;

FlatFeature parallelogram(const Vector2d& center, const Vector2d& u, const Vector2d& v) {
  FlatFeature feature;
  feature.center = center;
  feature.sides[0] = u;
  feature.sides[1] = v;
  feature.side_count = 2;
  return feature;
}

FlatFeature segment(const Vector2d& center, const Vector2d& u) {
  FlatFeature feature = parallelogram(center, u, {0, 0});
  feature.side_count = 1;
  return feature;
}

void expectCenter(const FlatFeature& feature, const Vector2d& half_extents,
                  const Vector2d& expected) {
  Vector2d center;
  ASSERT_TRUE(patchCenter(feature, half_extents, kTolerance, center));
  EXPECT_LE((center - expected).norm(), 1e-12) << center.transpose();
}

void expectNone(const FlatFeature& feature) {
  Vector2d center;
  EXPECT_FALSE(patchCenter(feature, kSquare, kTolerance, center));
}

TEST(Patch, pointInsideOnAndBeyondTheEdge) {
  FlatFeature point;
  point.center = {0.5, -0.5};
  expectCenter(point, kSquare, {0.5, -0.5});
  point.center = {1.0, -1.0};
  expectCenter(point, kSquare, {1.0, -1.0});
  point.center = {1.0 + 1e-9, 0.0};
  expectNone(point);
}

TEST(Patch, segmentAcross_middleOfTheStretchInside) {
  expectCenter(segment({1.5, 0.5}, {1, 0}), kSquare, {0.75, 0.5});
  expectCenter(segment({0, 1}, {2, 2}), kSquare, {-0.5, 0.5});  // from (-1, 0) to (0, 1)
}

TEST(Patch, segmentBeside_none) {
  expectNone(segment({0, 1.5}, {3, 0}));
  expectNone(segment({2, 2}, {1, -1}));
}

TEST(Patch, rectangleOverlapping_middleOfTheShared) {
  expectCenter(parallelogram({1.5, 1.0}, {1, 0}, {0, 1}), kSquare, {0.75, 0.5});
}

TEST(Patch, rectangleCoveringAll_middleOfTheFace) {
  expectCenter(parallelogram({0.5, 0.5}, {0, 4}, {4, 0}), kSquare, {0, 0});
}

TEST(Patch, cornerCutOff_centroidOfTheTriangle) {
  // The half plane x + y >= 1 leaves the triangle (1, 0), (1, 1), (0, 1).
  expectCenter(parallelogram({5.5, 5.5}, {5, 5}, {9, -9}), kSquare, {2.0 / 3, 2.0 / 3});
}

TEST(Patch, turnedSquareInside_itsOwnCenter) {
  expectCenter(parallelogram({0.1, 0.2}, {0.5, 0.5}, {-0.5, 0.5}), {2.0, 2.0}, {0.1, 0.2});
}

TEST(Patch, edgesTouch_middleOfTheSharedEdge) {
  expectCenter(parallelogram({2.0, 0.5}, {1, 0}, {0, 1}), kSquare, {1.0, 0.25});
}

TEST(Patch, faceOfNoWidth_middleOfTheLine) {
  expectCenter(parallelogram({0.5, 0.1}, {1, 0}, {0, 1}), {1.0, 0.0}, {0.25, 0.0});
  expectCenter(parallelogram({0.5, 0.1}, {0.7, 0.7}, {-0.7, 0.7}), {0.0, 0.0}, {0.0, 0.0});
}

TEST(Patch, rectangleBeyondACorner_none) {
  expectNone(parallelogram({2.0, 2.0}, {0.9, 0}, {0, 0.9}));
  expectNone(parallelogram({2.0, 2.0}, {0.9, -0.9}, {0.2, 0.2}));
}

}  // namespace
}  // namespace collision_monitor::test
