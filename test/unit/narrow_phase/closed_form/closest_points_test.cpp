// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/closest_points.h"

#include <gtest/gtest.h>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const Segment kUnitAlongX{Vector3d::Zero(), Vector3d::UnitX(), 1.0};

TEST(ClosestParameter, pointBeforeWithinAndAfter_threeCases) {
  EXPECT_EQ(closestParameter(kUnitAlongX, {-3, 1, 0}), -1.0);
  EXPECT_EQ(closestParameter(kUnitAlongX, {0.25, 7, 0}), 0.25);
  EXPECT_EQ(closestParameter(kUnitAlongX, {3, 0, -1}), 1.0);
}

TEST(ClosestParameters, crossing_bothWithin) {
  const Segment along_y{{0.5, 0.25, 2}, Vector3d::UnitY(), 1.0};
  const ClosestParameters found = closestParameters(kUnitAlongX, along_y);
  EXPECT_NEAR(found.on_a, 0.5, kExact);
  EXPECT_NEAR(found.on_b, -0.25, kExact);
}

TEST(ClosestParameters, firstClamped_secondIsItsFoot) {
  const Segment along_y{{4, 0.5, 0}, Vector3d::UnitY(), 1.0};
  const ClosestParameters found = closestParameters(kUnitAlongX, along_y);
  EXPECT_EQ(found.on_a, 1.0);
  EXPECT_NEAR(found.on_b, -0.5, kExact);
}

TEST(ClosestParameters, secondClamped_firstIsCorrected) {
  // The lines cross at (-5, 0), far beyond the start of b at (0.4, 5.4).
  const double s = std::sqrt(0.5);
  const Segment slanted{Vector3d(0.4, 5.4, 0) + Vector3d(s, s, 0), {s, s, 0}, 1.0};
  const ClosestParameters found = closestParameters(kUnitAlongX, slanted);
  EXPECT_NEAR(found.on_b, -1.0, kExact);
  EXPECT_NEAR(found.on_a, 0.4, kExact);
}

TEST(ClosestParameters, parallelWithSharedStretch_itsMiddle) {
  const Segment beside{{1.5, 1, 0}, Vector3d::UnitX(), 1.0};
  const ClosestParameters found = closestParameters(kUnitAlongX, beside);  // share x from 0.5 to 1
  EXPECT_NEAR(found.on_a, 0.75, kExact);
  EXPECT_NEAR(found.on_b, -0.75, kExact);
}

TEST(ClosestParameters, shortBesideLong_middleOfTheShort) {
  const Segment beside{{0.5, 1, 0}, -Vector3d::UnitX(), 0.25};
  const ClosestParameters found = closestParameters(kUnitAlongX, beside);
  EXPECT_NEAR(found.on_a, 0.5, kExact);
  EXPECT_NEAR(found.on_b, 0.0, kExact);
}

TEST(ClosestParameters, collinearApart_nearestEnds) {
  const Segment ahead{{4, 0, 0}, Vector3d::UnitX(), 1.0};
  const ClosestParameters found = closestParameters(kUnitAlongX, ahead);
  EXPECT_EQ(found.on_a, 1.0);
  EXPECT_EQ(found.on_b, -1.0);
}

TEST(ClosestParameters, bothPoints_zero) {
  const Segment point{{1, 2, 3}, Vector3d::UnitX(), 0.0};
  const Segment other{{4, 5, 6}, Vector3d::UnitY(), 0.0};
  const ClosestParameters found = closestParameters(point, other);
  EXPECT_EQ(found.on_a, 0.0);
  EXPECT_EQ(found.on_b, 0.0);
}

TEST(TowardsNormalCone, withinTheSegment_leavesWhatIsAcross) {
  expectNear(towardsNormalCone(kUnitAlongX, 0.5, {3, 1, 2}), {0, 1, 2}, "outward");
}

TEST(TowardsNormalCone, atAnEnd_keepsWhatLeadsBeyondIt) {
  expectNear(towardsNormalCone(kUnitAlongX, 1.0, {3, 1, 2}), {3, 1, 2}, "beyond");
  expectNear(towardsNormalCone(kUnitAlongX, 1.0, {-3, 1, 2}), {0, 1, 2}, "back");
  expectNear(towardsNormalCone(kUnitAlongX, -1.0, {-3, 1, 2}), {-3, 1, 2}, "beyond the start");
}

}  // namespace
}  // namespace collision_monitor::test
