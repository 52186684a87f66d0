// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support_fcl/solid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

/// A cube of side 2 without its top, which is at z = 1.
TriangleMesh openCube() {
  TriangleMesh mesh = boxMesh({1.0, 1.0, 1.0});
  const auto isTop = [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](auto corner) { return mesh.vertices[corner].z() > 0.5; });
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isTop),
                       mesh.triangles.end());
  EXPECT_EQ(mesh.triangles.size(), 10U);
  return mesh;
}

/// Of the middle of a ball on the cube's axis.
Holds holdsAt(double depth) {
  Pose world_from_ball;
  world_from_ball.translation = {0.0, 0.0, 1.0 - depth};
  return holdsMarkOf(insideOf(openCube()), Pose(), insideOf(Sphere{0.001}), world_from_ball);
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
  const Inside cube = insideOf(openCube());
  EXPECT_EQ(holdsMarkOf(cube, Pose(), insideOf(Box{{0.01, 0.01, 0.01}}), world_from_box),
            Holds::undecided);
  EXPECT_EQ(holdsMarkOf(cube, Pose(), insideOf(Box{{0.01, 0.01, 0.1}}), world_from_box),
            Holds::yes);
}

}  // namespace
}  // namespace collision_monitor::test
