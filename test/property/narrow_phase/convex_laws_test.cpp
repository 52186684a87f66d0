// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/convex_cases.h"
#include "support/fixed_seed.h"
#include "support/reference/convex_measure.h"

// Laws that hold for every two convex geometries. Lengths are whole millimetres and turns are often
// quarter turns, so that parallel, touching and concentric pairs are common.
namespace collision_monitor::test {
namespace {

constexpr double kClose = 2e-9;   // what two searches of one pair may differ by
constexpr double kPlaced = 1e-6;  // points and normals on curved surfaces have half the digits

double millimetres(int low, int high) { return 1e-3 * *rc::gen::inRange(low, high + 1); }

Eigen::Vector3d anyPoint(int reach) {
  return {millimetres(-reach, reach), millimetres(-reach, reach), millimetres(-reach, reach)};
}

ConvexHull anyHull() {
  const int count = *rc::gen::inRange(1, 20);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(anyPoint(100));
  }
  return ConvexHull(points);
}

ConvexGeometry anyGeometry(int kinds) {
  const double x = millimetres(0, 200);
  const double y = millimetres(0, 200);
  const double z = millimetres(0, 200);
  switch (*rc::gen::inRange(0, kinds)) {
    case 0:
      return Cylinder{z, x};
    case 1:
      return anyHull();
    case 2:
      return Sphere{x};
    case 3:
      return Capsule{z, x};
    case 4:
      return Box{{x, y, z}};
    case 5:
      return RoundedBox{{x, y, z}, millimetres(0, 100)};
    default:
      return HalfSpace{};
  }
}

Eigen::Matrix3d anyRotation() {
  Eigen::Matrix3d rotation = *rc::gen::arbitrary<bool>() ? zToX() : Eigen::Matrix3d::Identity();
  if (*rc::gen::arbitrary<bool>()) {
    const Eigen::Vector3d axis(millimetres(-9, 9), millimetres(-9, 9), 1e-3 + millimetres(0, 9));
    rotation = Eigen::AngleAxisd(millimetres(0, 3141), axis.normalized()) * rotation;
  }
  return rotation;
}

struct Pair {
  ConvexGeometry a;
  Pose world_from_a;
  ConvexGeometry b;
  Pose world_from_b;

  ConvexDistance measure() const { return measureCold(a, world_from_a, b, world_from_b); }
};

// At most one half space, and that is B; with a first kind that has no closed form of the family.
Pair anyPair() {
  const Pose pose_a{anyRotation(), anyPoint(1000)};
  const int reach = *rc::gen::element(100, 1000);
  const Pose pose_b = pose_a * Pose{anyRotation(), anyPoint(reach)};
  Pair pair{anyGeometry(2), pose_a, anyGeometry(7), pose_b};
  RC_LOG() << describe(PosedConvexPair{&pair.a, pair.world_from_a, &pair.b, pair.world_from_b});
  return pair;
}

// What may lie between two searches: nothing, or what a bound leaves open.
bool agree(const ConvexDistance& one, const ConvexDistance& other, double difference) {
  const bool are_exact = one.quality == Quality::exact && other.quality == Quality::exact;
  return std::abs(one.measured.distance - other.measured.distance - difference) <=
         (are_exact ? kClose : 1e-5);
}

RC_GTEST_PROP(ConvexLaws, swappedGeometries_haveTheSameDistance, ()) {
  const Pair pair = anyPair();
  const Pair swapped{pair.b, pair.world_from_b, pair.a, pair.world_from_a};
  RC_ASSERT(agree(pair.measure(), swapped.measure(), 0.0));
}

RC_GTEST_PROP(ConvexLaws, sameInput_givesTheSameBytes, ()) {
  const Pair pair = anyPair();
  const ConvexDistance first = pair.measure();
  const ConvexDistance second = pair.measure();
  RC_ASSERT(first.measured.distance == second.measured.distance);
  RC_ASSERT(first.measured.point_on_a == second.measured.point_on_a);
  RC_ASSERT(first.measured.normal_a_to_b == second.measured.normal_a_to_b);
}

RC_GTEST_PROP(ConvexLaws, oneRigidMotionOnBoth_changesNothing, ()) {
  const Pair pair = anyPair();
  const Pose motion{anyRotation(), anyPoint(1000)};
  const Pair moved{pair.a, motion * pair.world_from_a, pair.b, motion * pair.world_from_b};
  RC_ASSERT(agree(pair.measure(), moved.measure(), 0.0));
}

RC_GTEST_PROP(ConvexLaws, movingOne_changesTheDistanceByNoMore, ()) {
  Pair pair = anyPair();
  const double before = pair.measure().measured.distance;
  const Eigen::Vector3d step = anyPoint(50);
  pair.world_from_a.translation += step;
  RC_ASSERT(std::abs(pair.measure().measured.distance - before) <= step.norm() + 1e-5);
}

RC_GTEST_PROP(ConvexLaws, movingByTheDistanceAlongTheNormal_makesThemTouch, ()) {
  Pair pair = anyPair();
  const ConvexDistance before = pair.measure();
  RC_PRE(before.quality == Quality::exact);
  pair.world_from_a.translation += before.measured.distance * before.measured.normal_a_to_b;
  RC_ASSERT(std::abs(pair.measure().measured.distance) <= kPlaced);
}

RC_GTEST_PROP(ConvexLaws, answer_isProvenByItsNormalAndPoints, ()) {
  const Pair pair = anyPair();
  const ConvexDistance found = pair.measure();
  const SignedDistance& measured = found.measured;
  RC_ASSERT(std::abs(measured.normal_a_to_b.norm() - 1.0) <= 1e-14);
  RC_ASSERT((measured.point_on_b - measured.point_on_a - measured.distance * measured.normal_a_to_b)
                .norm() <= 1e-14);
  const ConvexCertificate proof =
      certify({&pair.a, pair.world_from_a, &pair.b, pair.world_from_b}, measured);
  if (!std::holds_alternative<HalfSpace>(pair.b)) {  // whose own normal is rounded
    RC_ASSERT(std::abs(proof.gap_along_normal - measured.distance) <= kClose);
  }
  if (found.quality == Quality::exact) {
    RC_ASSERT(proof.a_outside <= kPlaced && proof.b_outside <= kPlaced);
  }
}

RC_GTEST_PROP(ConvexLaws, warmStartFromAnotherPose_changesNoDistance, ()) {
  Pair pair = anyPair();
  ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  signedDistanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b, search);
  pair.world_from_b = Pose{anyRotation(), anyPoint(10)} * pair.world_from_b;
  const ConvexDistance hot =
      signedDistanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b, search);
  RC_ASSERT(agree(hot, pair.measure(), 0.0));
}

RC_GTEST_PROP(ConvexLaws, hullOfABoxesCorners_isTheBox, ()) {
  const Pair pair = anyPair();
  const Eigen::Vector3d half(millimetres(0, 200), millimetres(0, 200), millimetres(0, 200));
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                         (i & 4) != 0 ? half.z() : -half.z());
  }
  const ConvexDistance of_box =
      measureCold(Box{half}, pair.world_from_a, pair.b, pair.world_from_b);
  const ConvexDistance of_hull =
      measureCold(ConvexHull(corners), pair.world_from_a, pair.b, pair.world_from_b);
  RC_ASSERT(agree(of_box, of_hull, 0.0));
}

}  // namespace
}  // namespace collision_monitor::test
