// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/separating_axes.h"

#include <gtest/gtest.h>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

BoxPair pairAt(const Vector3d& center_of_b, const Eigen::Matrix3d& a_from_b) {
  return {a_from_b, center_of_b, {1, 2, 3}, {0.5, 0.25, 1.5}};
}

TEST(SeparatingAxes, alignedBoxes_gapsAlongTheThreeAxesTwice) {
  const Separations found = separationsOfBoxes(pairAt({5, -1, 3}, Eigen::Matrix3d::Identity()));
  const double expected[] = {3.5, -1.25, -1.5};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.along[k], expected[k], kExact);
    EXPECT_NEAR(found.along[kFirstFaceOfB + k], expected[k], kExact);
  }
  EXPECT_NEAR(found.largest, 3.5, kExact);
}

TEST(SeparatingAxes, parallelEdges_areNoAxis) {
  const Separations found = separationsOfBoxes(pairAt({5, -1, 3}, Eigen::Matrix3d::Identity()));
  for (const std::size_t parallel : {0U, 4U, 8U}) {
    EXPECT_TRUE(std::isinf(found.along[kFirstEdgePair + parallel]));
  }
}

TEST(SeparatingAxes, everyAxis_isTheGapOfTheProjections) {
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(0.7, Vector3d::UnitX()) * Eigen::AngleAxisd(-1.1, Vector3d::UnitY()) *
       Eigen::AngleAxisd(2.3, Vector3d::UnitZ()))
          .toRotationMatrix();
  const BoxPair pair = pairAt({1.5, -2.5, 3.5}, turned);
  const Separations found = separationsOfBoxes(pair);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const Vector3d direction = axisDirection(pair, axis);
    EXPECT_NEAR(direction.norm(), 1.0, kExact);
    const double reach_a = direction.cwiseAbs().dot(pair.half_a);
    const double reach_b = (turned.transpose() * direction).cwiseAbs().dot(pair.half_b);
    EXPECT_NEAR(found.along[axis], direction.dot(pair.center_of_b) - reach_a - reach_b, kExact)
        << "axis " << axis;
    EXPECT_GE(direction.dot(pair.center_of_b), 0.0);
  }
}

// With products taken from the rotation's entries instead of its minors, the gap along the cross
// product of edges at this angle would be wrong by about 1e-16 / 1e-9.
TEST(SeparatingAxes, edgesAtAnAngleOf1e9_gapIsStillThatOfTheProjections) {
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(1e-9, Vector3d(0.6, 0.8, 0)) * Eigen::AngleAxisd(1.3, Vector3d::UnitZ()))
          .toRotationMatrix();
  const BoxPair pair = pairAt({1.5, -2.5, 3.5}, turned);
  const Separations found = separationsOfBoxes(pair);
  const std::size_t axis = kFirstEdgePair + 8;  // z of A with z of B
  const Vector3d direction = axisDirection(pair, axis);
  const double reach_a = direction.cwiseAbs().dot(pair.half_a);
  const double reach_b = (turned.transpose() * direction).cwiseAbs().dot(pair.half_b);
  EXPECT_NEAR(found.along[axis], direction.dot(pair.center_of_b) - reach_a - reach_b, kExact);
}

TEST(SeparatingAxes, boxAndSegment_sixAxesOfTheFifteen) {
  BoxPair pair = pairAt({1.5, -2.5, 3.5}, eighthTurn() * zToX());
  pair.half_b = {0, 0, 1.5};
  const Separations boxes = separationsOfBoxes(pair);
  const Separations segment = separationsOfBoxAndSegment(pair);
  for (const std::size_t axis : {0U, 1U, 2U, 8U, 11U, 14U}) {
    EXPECT_NEAR(segment.along[axis], boxes.along[axis], kExact) << "axis " << axis;
  }
  EXPECT_NEAR(segment.largest, boxes.largest, kExact);
}

}  // namespace
}  // namespace collision_monitor::test
