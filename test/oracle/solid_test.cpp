// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support_fcl/solid.h"

#include <gtest/gtest.h>

#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

/// Of the middle of a ball on the axis of a cube of side 2 without its top, which is at z = 1.
Holds holdsAt(double depth) {
  Pose world_from_ball;
  world_from_ball.translation = {0.0, 0.0, 1.0 - depth};
  return holdsMarkOf(insideOf(openBoxMesh({1.0, 1.0, 1.0})), Pose(), insideOf(Sphere{0.001}),
                     world_from_ball);
}

// The missing top fills 4 asin(1 / (1 + depth^2)) of all directions, which are 4 pi.
TEST(Solid, mouthOfAnOpenMesh_isUndecidedWhereEitherAnswerIsRight) {
  EXPECT_EQ(holdsAt(1.0), Holds::yes);
  EXPECT_EQ(holdsAt(0.05), Holds::yes) << "0.5225";
  EXPECT_EQ(holdsAt(0.04), Holds::undecided) << "0.518";
  EXPECT_EQ(holdsAt(0.01), Holds::undecided) << "0.5045";
  EXPECT_EQ(holdsAt(-0.01), Holds::no) << "0.4955";
}

TEST(Solid, oneMarkInside_isEnough) {
  Pose world_from_box;
  world_from_box.translation = {0.0, 0.0, 0.97};
  const Inside cube = insideOf(openBoxMesh({1.0, 1.0, 1.0}));
  EXPECT_EQ(holdsMarkOf(cube, Pose(), insideOf(Box{{0.01, 0.01, 0.01}}), world_from_box),
            Holds::undecided);
  EXPECT_EQ(holdsMarkOf(cube, Pose(), insideOf(Box{{0.01, 0.01, 0.1}}), world_from_box),
            Holds::yes);
}

}  // namespace
}  // namespace collision_monitor::test
