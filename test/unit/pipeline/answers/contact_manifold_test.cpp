// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/contact_manifold.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

/// The manifold of the closest pair, link 1 placed by the pose.
std::optional<ContactManifold> manifoldAt(const std::vector<Geometry>& geometries, const Pose& pose,
                                          double padding = 0.0) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.padding = padding;
  const CycleSetup setup = test::geometrySetup(geometries, options);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = test::knownPoses(setup);
  poses.world_from_link[1] = pose;
  runCycle(setup, poses, buffers);
  return contactManifold(setup, buffers.body_poses,
                         buffers.distances.pairs.at(buffers.events.closest_of_all));
}

Pose at(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
}

const TriangleMesh kCube = test::boxMesh({0.1, 0.1, 0.1});

TEST(ContactManifoldOfPair, boxMeshOnBoxMesh_cornersOfTheSharedFace) {
  const auto manifold = manifoldAt({kCube, kCube}, at(0.05, 0.0, 0.19));
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::face_face);
  ASSERT_EQ(manifold->size, 4U);
  for (const ManifoldPoint& point : manifold->points) {
    EXPECT_NEAR(point.distance, -0.01, 1e-7);
    EXPECT_NEAR(point.point_on_a.z(), 0.1, 1e-7);
    EXPECT_NEAR(point.point_on_b.z(), 0.09, 1e-7);
    EXPECT_TRUE(std::abs(point.point_on_a.x() + 0.05) < 1e-7 ||
                std::abs(point.point_on_a.x() - 0.1) < 1e-7);
  }
}

TEST(ContactManifoldOfPair, boxMeshOnItsEdge_twoPoints) {
  Pose pose = at(0.0, 0.0, 0.1 + 0.1 * std::sqrt(2.0) - 0.01);
  pose.rotation = Eigen::AngleAxisd(0.25 * M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto manifold = manifoldAt({kCube, kCube}, pose);
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::edge_face);
  ASSERT_EQ(manifold->size, 2U);
  EXPECT_NEAR(std::abs(manifold->points[0].point_on_a.x()), 0.1, 1e-7);
}

TEST(ContactManifoldOfPair, manySidedPrism_keepsPointsOnItsFace) {
  const auto manifold = manifoldAt({test::prismMesh(0.05, 0.1, 40), kCube}, at(0.0, 0.0, 0.195));
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::face_face);
  ASSERT_EQ(manifold->size, 4U);
  for (const ManifoldPoint& point : manifold->points) {
    EXPECT_NEAR(point.point_on_a.z(), 0.1, 1e-7);
    EXPECT_LE(point.point_on_a.head<2>().norm(), 0.05 + 1e-9);
  }
}

TEST(ContactManifoldOfPair, padding_movesThePointsOut) {
  const auto manifold = manifoldAt({kCube, kCube}, at(0.0, 0.0, 0.2), 0.003);
  ASSERT_TRUE(manifold.has_value());
  ASSERT_EQ(manifold->size, 4U);
  EXPECT_NEAR(manifold->points[0].point_on_a.z(), 0.103, 1e-7);
  EXPECT_NEAR(manifold->points[0].point_on_b.z(), 0.097, 1e-7);
}

TEST(ContactManifoldOfPair, concaveMesh_none) {
  EXPECT_FALSE(manifoldAt({test::angleMesh(), kCube}, at(0.05, 0.05, 0.14)).has_value());
}

TEST(ContactManifoldOfPair, cylinderStandingOnBox_fourPointsAroundTheRim) {
  const auto manifold = manifoldAt({kCube, Cylinder{0.1, 0.05}}, at(0.02, 0.0, 0.19));
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::face_face);
  ASSERT_EQ(manifold->size, 4U);
  const Eigen::Vector3d middle(0.02, 0.0, 0.1);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ManifoldPoint& point : manifold->points) {
    EXPECT_NEAR(point.distance, -0.01, 1e-7);
    EXPECT_NEAR((point.point_on_a - middle).norm(), 0.05, 1e-7);
    sum += point.point_on_a - middle;
  }
  EXPECT_LE(sum.norm(), 1e-7) << "a quarter turn apart";
  EXPECT_LE((manifold->center.point_on_a - middle).norm(), 1e-7);
}

TEST(ContactManifoldOfPair, cylinderLyingOnBox_twoEndsOfTheSharedLine) {
  Pose lying = at(0.05, 0.0, 0.14);
  lying.rotation = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto manifold = manifoldAt({kCube, Cylinder{0.1, 0.05}}, lying);
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::edge_face);
  ASSERT_EQ(manifold->size, 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(manifold->points[i].distance, -0.01, 1e-7);
    EXPECT_NEAR(std::abs(manifold->points[i].point_on_a.x() - 0.025), 0.075, 1e-7);
    EXPECT_NEAR(manifold->points[i].point_on_a.y(), 0.0, 1e-7);
  }
}

TEST(ContactManifoldOfPair, cylinderOnCylinder_capsShareFourPointsAndCrossedSidesOne) {
  const Cylinder cylinder{0.1, 0.05};
  const auto caps = manifoldAt({cylinder, cylinder}, at(0.0, 0.0, 0.199));
  ASSERT_TRUE(caps.has_value());
  EXPECT_EQ(caps->size, 4U);
  Pose crossed = at(0.0, 0.099, 0.0);
  crossed.rotation = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto sides = manifoldAt({cylinder, cylinder}, crossed);
  ASSERT_TRUE(sides.has_value());
  EXPECT_EQ(sides->feature, ContactFeature::edge_edge);
  EXPECT_EQ(sides->size, 1U);
}

TEST(ContactManifoldOfPair, cylinderOnItsRim_onePoint) {
  Pose leaning = at(0.0, 0.0, 0.1 + (0.1 + 0.05) * std::sqrt(0.5) - 0.001);
  leaning.rotation = Eigen::AngleAxisd(0.25 * M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto manifold = manifoldAt({kCube, Cylinder{0.1, 0.05}}, leaning);
  ASSERT_TRUE(manifold.has_value());
  EXPECT_EQ(manifold->feature, ContactFeature::vertex_face);
  EXPECT_EQ(manifold->size, 1U);
}

}  // namespace
}  // namespace collision_monitor
