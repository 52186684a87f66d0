// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

const Shape kShapes[] = {Sphere{0.5}, Capsule{1.0, 0.25}, Box{{1.0, 0.5, 0.75}},
                         RoundedBox{{0.5, 0.5, 1.0}, 0.25}};

TEST(AnyPair, inTheOtherOrder_isTheSameAnswerSwapped) {
  const Pose pose_a{eighthTurn(), {0.1, 0.2, 0.3}};
  const Pose pose_b{zToX(), {4, 3, 2}};
  for (const Shape& a : kShapes) {
    for (const Shape& b : kShapes) {
      SCOPED_TRACE(std::string(kindName(a)) + " and " + kindName(b));
      const SignedDistance ab = distanceBetween(a, pose_a, b, pose_b);
      const SignedDistance ba = distanceBetween(b, pose_b, a, pose_a);
      EXPECT_NEAR(ab.distance, ba.distance, kExact);
      expectNear(ab.normal_a_to_b, -ba.normal_a_to_b, "normal");
      expectNear(ab.point_on_a, ba.point_on_b, "point on a");
      expectNear(ab.point_on_b, ba.point_on_a, "point on b");
    }
  }
}

TEST(AnyPair, box_isARoundedBoxOfRadiusZero) {
  const Pose pose_b{eighthTurn(), {3, 1, 2}};
  const Shape box = Box{{1.0, 0.5, 0.75}};
  const Shape rounded = RoundedBox{{1.0, 0.5, 0.75}, 0.0};
  for (const Shape& a : kShapes) {
    SCOPED_TRACE(kindName(a));
    const SignedDistance with_box = distanceBetween(a, Pose{}, box, pose_b);
    const SignedDistance with_rounded = distanceBetween(a, Pose{}, rounded, pose_b);
    EXPECT_EQ(with_box.distance, with_rounded.distance);
    EXPECT_EQ(with_box.point_on_b, with_rounded.point_on_b);
  }
}

TEST(AnyPair, sphereBesideBox_goesThroughTheVariant) {
  const Shape box = Box{{1.0, 2.0, 3.0}};
  const Shape sphere = Sphere{1.0};
  const auto found = distanceBetween(box, Pose{}, sphere, at(4, 6, 0));
  expectDistance(found, 4.0, {0.6, 0.8, 0}, {1, 2, 0});
}

TEST(AnyPair, normalPointsFromAToB) {
  for (const Shape& a : kShapes) {
    for (const Shape& b : kShapes) {
      const SignedDistance found = distanceBetween(a, Pose{}, b, at(0, 0, 10));
      EXPECT_GT(found.normal_a_to_b.z(), 0.9) << kindName(a) << " and " << kindName(b);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
