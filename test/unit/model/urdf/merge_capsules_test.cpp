// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/urdf/merge_capsules.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace collision_monitor {
namespace {

CollisionElement element(const std::string& name, const Eigen::Vector3d& position,
                         const Geometry& geometry) {
  CollisionElement collision;
  collision.name = name;
  collision.link_from_geometry.translation = position;
  collision.geometry = geometry;
  return collision;
}

std::vector<CollisionElement> triple(double sphere_radius, double top) {
  return {element("middle", {1.0, 0.0, 0.0}, Cylinder{0.5, 0.1}),
          element("top", {1.0, 0.0, top}, Sphere{sphere_radius}),
          element("bottom", {1.0, 0.0, -0.5}, Sphere{sphere_radius})};
}

TEST(MergeCapsules, cylinderWithTwoSpheres_isOneCapsule) {
  auto collisions = triple(0.1, 0.5);
  mergeCapsules(collisions);
  ASSERT_EQ(collisions.size(), 1u);
  EXPECT_EQ(collisions[0].name, "middle");
  EXPECT_EQ(collisions[0].link_from_geometry.translation, Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(std::get<Capsule>(collisions[0].geometry).half_length, 0.5);
  EXPECT_EQ(std::get<Capsule>(collisions[0].geometry).radius, 0.1);
}

TEST(MergeCapsules, sphereOffByRounding_isEnclosed) {
  auto collisions = triple(0.1, 0.5 + 5e-7);
  mergeCapsules(collisions);
  ASSERT_EQ(collisions.size(), 1u);
  EXPECT_NEAR(std::get<Capsule>(collisions[0].geometry).radius, 0.1 + 5e-7, 1e-12);
}

TEST(MergeCapsules, sphereOffByMore_staysThree) {
  auto collisions = triple(0.1, 0.5 + 5e-6);
  mergeCapsules(collisions);
  EXPECT_EQ(collisions.size(), 3u);
}

TEST(MergeCapsules, otherRadius_staysThree) {
  auto collisions = triple(0.11, 0.5);
  mergeCapsules(collisions);
  EXPECT_EQ(collisions.size(), 3u);
}

TEST(MergeCapsules, oneSphereMissing_staysTwo) {
  auto collisions = triple(0.1, 0.5);
  collisions.pop_back();
  mergeCapsules(collisions);
  EXPECT_EQ(collisions.size(), 2u);
}

TEST(MergeCapsules, anglesOfFourDecimals_stillMerge) {
  // The cylinder lies along x by a pitch of 1.5708, the spheres are put there exactly.
  std::vector<CollisionElement> collisions{element("middle", {0.0, 0.0, 0.0}, Cylinder{0.1, 0.05}),
                                           element("front", {0.1, 0.0, 0.0}, Sphere{0.05}),
                                           element("back", {-0.1, 0.0, 0.0}, Sphere{0.05})};
  collisions[0].link_from_geometry.rotation =
      Eigen::AngleAxisd(1.5708, Eigen::Vector3d::UnitY()).toRotationMatrix();
  mergeCapsules(collisions);
  ASSERT_EQ(collisions.size(), 1u);
  EXPECT_NEAR(std::get<Capsule>(collisions[0].geometry).radius, 0.05, 4e-7);
}

TEST(MergeCapsules, twoCylindersShareASphere_givesTwoCapsules) {
  std::vector<CollisionElement> collisions{element("lower", {0.0, 0.0, 0.5}, Cylinder{0.5, 0.1}),
                                           element("upper", {0.0, 0.0, 1.5}, Cylinder{0.5, 0.1}),
                                           element("s0", {0.0, 0.0, 0.0}, Sphere{0.1}),
                                           element("s1", {0.0, 0.0, 1.0}, Sphere{0.1}),
                                           element("s2", {0.0, 0.0, 2.0}, Sphere{0.1}),
                                           element("far", {9.0, 0.0, 0.0}, Sphere{0.1})};
  mergeCapsules(collisions);
  ASSERT_EQ(collisions.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<Capsule>(collisions[0].geometry));
  EXPECT_TRUE(std::holds_alternative<Capsule>(collisions[1].geometry));
  EXPECT_EQ(collisions[2].name, "far");
}

}  // namespace
}  // namespace collision_monitor
