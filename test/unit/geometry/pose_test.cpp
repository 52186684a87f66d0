// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/pose.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_poses.h"

namespace collision_monitor {
namespace {

/// A quarter turn about z: x becomes y.
Pose quarterTurn() {
  Pose pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  pose.translation = {1.0, 2.0, 3.0};
  return pose;
}

TEST(Pose, placesAPoint) {
  EXPECT_EQ(quarterTurn() * Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 3, 3));
}

TEST(Pose, chainPlacesAsItsLinksDo) {
  const Eigen::Vector3d point(0.5, -1.0, 2.0);
  EXPECT_EQ((quarterTurn() * quarterTurn()) * point, quarterTurn() * (quarterTurn() * point));
}

TEST(Pose, inverseUndoes) {
  test::Random random(5);
  for (int round = 0; round < 100; ++round) {
    const Pose pose = test::randomPose(random, 10.0);
    const Pose identity = inverse(pose) * pose;
    EXPECT_TRUE(identity.rotation.isIdentity(1e-14));
    EXPECT_TRUE(identity.translation.isZero(1e-13));
  }
}

TEST(IsRigid, tellsRotationsFromTheRest) {
  EXPECT_TRUE(isRigid(quarterTurn()));
  Pose mirrored;
  mirrored.rotation(0, 0) = -1.0;
  EXPECT_FALSE(isRigid(mirrored));
  Pose scaled;
  scaled.rotation *= 1.001;
  EXPECT_FALSE(isRigid(scaled));
  Pose skewed;
  skewed.rotation(0, 1) = 2e-6;
  EXPECT_FALSE(isRigid(skewed));
  EXPECT_TRUE(isRigid(skewed, 1e-5));
}

TEST(IsRigid, anyNumberThatIsNotFinite_isNot) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1e300}) {
    for (int i = 0; i < 9; ++i) {
      Pose turned;
      turned.rotation.data()[i] = bad;
      EXPECT_FALSE(isRigid(turned)) << i << " of the rotation is " << bad;
    }
  }
  for (int i = 0; i < 3; ++i) {
    Pose moved;
    moved.translation[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isRigid(moved));
    moved.translation[i] = -std::numeric_limits<double>::infinity();
    EXPECT_FALSE(isRigid(moved));
  }
}

}  // namespace
}  // namespace collision_monitor
