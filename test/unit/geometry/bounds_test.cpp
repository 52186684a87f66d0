// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/bounds.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/random_poses.h"

namespace collision_monitor {
namespace {

TEST(AabbOf, turnedCapsule_isTightOnItsEnds) {
  // A capsule along z, turned 45 degrees about y: its ends reach (1 / sqrt 2) along x and z.
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.7853981633974483, Eigen::Vector3d::UnitY()).matrix();
  pose.translation = {10.0, 0.0, 0.0};
  const Aabb box = aabbOf(Capsule{1.0, 0.25}, pose, 0.0);
  const double reach = std::sqrt(0.5) + 0.25;
  EXPECT_TRUE(box.min.isApprox(Eigen::Vector3d(10.0 - reach, -0.25, -reach), 1e-12));
  EXPECT_TRUE(box.max.isApprox(Eigen::Vector3d(10.0 + reach, 0.25, reach), 1e-12));
}

TEST(AabbOf, marginGrowsEverySide) {
  const Aabb box = aabbOf(Sphere{1.0}, Pose{}, 0.5);
  EXPECT_TRUE(box.min.isApprox(Eigen::Vector3d::Constant(-1.5), 1e-12));
  EXPECT_TRUE(box.max.isApprox(Eigen::Vector3d::Constant(1.5), 1e-12));
}

TEST(Meets, touchingBoxesMeetAndBoxesApartDoNot) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(meets(box, {{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(meets(box, {{0, 0, 1.001}, {1, 1, 2}}));
}

TEST(BoundsProperty, boxAndSphereHoldEverySupportPoint) {
  constexpr unsigned kSeed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  test::Random random(kSeed);
  const Shape shapes[] = {Sphere{0.3}, Capsule{0.7, 0.1}, Box{{0.1, 0.5, 0.9}},
                          RoundedBox{{0.2, 0.0, 0.4}, 0.15}};
  for (int round = 0; round < 2000; ++round) {
    const Shape& shape = shapes[round % 4];
    const Pose pose = test::randomPose(random, 100.0);
    const Aabb box = aabbOf(shape, pose, 0.0);
    const Eigen::Vector3d point = supportPoint(shape, test::randomPoint(random, 1.0));
    const Eigen::Vector3d in_world = pose * point;
    ASSERT_TRUE((in_world.array() >= box.min.array()).all());
    ASSERT_TRUE((in_world.array() <= box.max.array()).all());
    ASSERT_LE(point.norm(), boundingRadius(shape));
  }
}

}  // namespace
}  // namespace collision_monitor
