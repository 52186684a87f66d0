// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/random_pairs.h"

// Laws that hold for every pair of shapes. Lengths are whole millimetres and angles whole
// milliradians, so that parallel, touching and concentric pairs are common, and a counterexample
// shrinks to small numbers.
namespace collision_monitor::test::distance_laws {
namespace {

const bool kHasManyCases = askForCases(3000);

double millimetres(int low, int high) { return 1e-3 * *rc::gen::inRange(low, high + 1); }

// Mostly link sized, sometimes up to 5 m, so that no core is longer than 10 m.
double length() {
  return *rc::gen::inRange(0, 4) == 0 ? millimetres(0, 5000) : millimetres(0, 100);
}

Shape anyShape() {
  const int kind = *rc::gen::inRange(0, 4);
  const Eigen::Vector3d half_extents(length(), length(), length());
  const double radius = length();
  switch (kind) {
    case 0:
      return Sphere{radius};
    case 1:
      return Capsule{half_extents.z(), radius};
    case 2:
      return Box{half_extents};
    default:
      return RoundedBox{half_extents, radius};
  }
}

Eigen::Matrix3d anyRotation() {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (*rc::gen::arbitrary<bool>()) {
    rotation = zToX();
  }
  if (*rc::gen::arbitrary<bool>()) {
    rotation = zToY() * rotation;
  }
  if (*rc::gen::arbitrary<bool>()) {
    const Eigen::Vector3d axis(millimetres(-9, 9), millimetres(-9, 9), 1e-3 + millimetres(0, 9));
    rotation = Eigen::AngleAxisd(millimetres(0, 3141), axis.normalized()) * rotation;
  }
  return rotation;
}

Eigen::Vector3d anyOffset() {
  const int reach = *rc::gen::element(100, 1000, 10000);
  return {millimetres(-reach, reach), millimetres(-reach, reach), millimetres(-reach, reach)};
}

ShapePair anyPair() {
  const Pose pose_a{anyRotation(), anyOffset()};
  // Often near: B is given relative to A.
  const Pose pose_b = pose_a * Pose{anyRotation(), anyOffset()};
  return {anyShape(), pose_a, anyShape(), pose_b};
}

SignedDistance measure(const ShapePair& pair) {
  return distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
}

void logPair(const ShapePair& pair) { RC_LOG() << describe(pair); }

RC_GTEST_PROP(DistanceLaws, swappedShapes_haveTheSameDistance, ()) {
  const ShapePair pair = anyPair();
  logPair(pair);
  const SignedDistance ab = measure(pair);
  const SignedDistance ba = measure({pair.b, pair.world_from_b, pair.a, pair.world_from_a});
  RC_ASSERT(std::abs(ab.distance - ba.distance) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, sameInput_givesTheSameBytes, ()) {
  const ShapePair pair = anyPair();
  const SignedDistance first = measure(pair);
  const SignedDistance second = measure(pair);
  RC_ASSERT(first.distance == second.distance);
  RC_ASSERT(first.point_on_a == second.point_on_a && first.point_on_b == second.point_on_b);
  RC_ASSERT(first.normal_a_to_b == second.normal_a_to_b);
}

RC_GTEST_PROP(DistanceLaws, oneRigidMotionOnBoth_changesNothing, ()) {
  const ShapePair pair = anyPair();
  logPair(pair);
  const Pose motion{anyRotation(), anyOffset()};
  const SignedDistance before = measure(pair);
  const SignedDistance after =
      measure({pair.a, motion * pair.world_from_a, pair.b, motion * pair.world_from_b});
  RC_ASSERT(std::abs(after.distance - before.distance) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, movingOneShape_changesTheDistanceByNoMore, ()) {
  ShapePair pair = anyPair();
  logPair(pair);
  const double before = measure(pair).distance;
  const Eigen::Vector3d step = 0.1 * anyOffset();
  pair.world_from_a.translation += step;
  RC_ASSERT(std::abs(measure(pair).distance - before) <= step.norm() + kExact);
}

RC_GTEST_PROP(DistanceLaws, movingByTheDistanceAlongTheNormal_makesThemTouch, ()) {
  ShapePair pair = anyPair();
  logPair(pair);
  const SignedDistance before = measure(pair);
  pair.world_from_a.translation += before.distance * before.normal_a_to_b;
  RC_ASSERT(std::abs(measure(pair).distance) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, points_lieOnTheirSurfaces, ()) {
  const ShapePair pair = anyPair();
  logPair(pair);
  const SignedDistance found = measure(pair);
  RC_ASSERT(std::abs(signedDistanceTo(pair.a, inverse(pair.world_from_a) * found.point_on_a)) <=
            kExact);
  RC_ASSERT(std::abs(signedDistanceTo(pair.b, inverse(pair.world_from_b) * found.point_on_b)) <=
            kExact);
}

RC_GTEST_PROP(DistanceLaws, normal_isUnitAndJoinsThePoints, ()) {
  const ShapePair pair = anyPair();
  logPair(pair);
  const SignedDistance found = measure(pair);
  RC_ASSERT(std::abs(found.normal_a_to_b.norm() - 1.0) <= kExact);
  const Eigen::Vector3d joined = found.point_on_b - found.point_on_a;
  RC_ASSERT((joined - found.distance * found.normal_a_to_b).norm() <= kExact);
}

// Both shapes lie on their own sides of planes one distance apart: no answer with a wrong
// normal can pass this, and a distance that is too large cannot either.
RC_GTEST_PROP(DistanceLaws, normal_separatesTheShapesByTheDistance, ()) {
  const ShapePair pair = anyPair();
  logPair(pair);
  const SignedDistance found = measure(pair);
  const auto farthest = [](const Shape& shape, const Pose& pose, const Eigen::Vector3d& direction) {
    return direction.dot(pose * supportPoint(shape, pose.rotation.transpose() * direction));
  };
  const double end_of_a = farthest(pair.a, pair.world_from_a, found.normal_a_to_b);
  const double start_of_b = -farthest(pair.b, pair.world_from_b, -found.normal_a_to_b);
  RC_ASSERT(std::abs(start_of_b - end_of_a - found.distance) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, roundedBoxWithoutExtents_isASphere, ()) {
  ShapePair pair = anyPair();
  logPair(pair);
  const double radius = length();
  pair.b = Sphere{radius};
  const double of_sphere = measure(pair).distance;
  pair.b = RoundedBox{Eigen::Vector3d::Zero(), radius};
  RC_ASSERT(std::abs(measure(pair).distance - of_sphere) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, roundedBoxWithOneExtent_isACapsule, ()) {
  ShapePair pair = anyPair();
  logPair(pair);
  const Capsule capsule{length(), length()};
  pair.b = capsule;
  const double of_capsule = measure(pair).distance;
  pair.b = RoundedBox{{0.0, 0.0, capsule.half_length}, capsule.radius};
  RC_ASSERT(std::abs(measure(pair).distance - of_capsule) <= kExact);
}

RC_GTEST_PROP(DistanceLaws, largerRadius_bringsTheSurfaceNearerByItsGrowth, ()) {
  ShapePair pair = anyPair();
  logPair(pair);
  const Eigen::Vector3d half_extents = coreHalfExtents(pair.a);
  const double growth = length();
  const double before = measure(pair).distance;
  pair.a = RoundedBox{half_extents, radiusOf(pair.a) + growth};
  RC_ASSERT(std::abs(measure(pair).distance - (before - growth)) <= kExact);
}

}  // namespace
}  // namespace collision_monitor::test::distance_laws
