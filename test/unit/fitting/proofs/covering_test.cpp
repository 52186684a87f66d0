// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/covering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 1e-5;

Pose at(double x, double y, double z) { return {Eigen::Matrix3d::Identity(), {x, y, z}}; }

Covering cover(const Geometry& geometry, const std::vector<PosedShape>& shapes,
               const Pose& link_from_geometry = {}) {
  return proveCovering({{link_from_geometry, &geometry}}, shapes, kTolerance);
}

TEST(Covering, largerShape_coversWithoutWidening) {
  const Covering covering = cover(test::boxMesh({0.1, 0.2, 0.3}),
                                  {{Box{{0.1001, 0.2, 0.3}}, {}}, {Box{{0.2, 0.21, 0.31}}, {}}});
  EXPECT_TRUE(covering.is_proven);
  EXPECT_EQ(covering.widening, 0.0);
}

TEST(Covering, smallerShape_namesTheFarthestVertexAndItsDistance) {
  TriangleMesh mesh = test::boxMesh({0.1, 0.2, 0.3});
  mesh.vertices[0].x() *= 1.03;  // 3 mm farther out than the box
  const Covering covering = cover(mesh, {{Box{{0.1, 0.2, 0.3}}, {}}});
  EXPECT_FALSE(covering.is_proven);
  EXPECT_NEAR(covering.excess, 0.003, 1e-12);
  EXPECT_EQ(covering.farthest, mesh.vertices[0]);
}

TEST(Covering, geometryIsPlacedOnItsLink) {
  const Geometry geometry = Box{{0.1, 0.1, 0.1}};
  EXPECT_TRUE(cover(geometry, {{Sphere{0.2}, at(1.0, 0.0, 0.0)}}, at(1.0, 0.0, 0.0)).is_proven);
  const Covering covering = cover(geometry, {{Sphere{0.2}, {}}}, at(1.0, 0.0, 0.0));
  EXPECT_FALSE(covering.is_proven);
  EXPECT_NEAR(covering.excess, std::sqrt(1.1 * 1.1 + 0.02) - 0.2, 1e-12);
}

TEST(Covering, digitsOfAFile_areGrownBack) {
  const Covering covering = cover(Box{{0.1, 0.2, 0.3}}, {{Box{{0.1 - 4e-9, 0.2, 0.3}}, {}}});
  EXPECT_TRUE(covering.is_proven);
  EXPECT_GE(covering.widening, 4e-9);
  EXPECT_LE(covering.widening, 1e-7);
  EXPECT_FALSE(cover(Box{{0.1, 0.2, 0.3}}, {{Box{{0.1 - 2e-5, 0.2, 0.3}}, {}}}).is_proven);
}

TEST(Covering, twoHalvesThatOverlap_coverTogether) {
  const Geometry geometry = test::boxMesh({0.1, 0.1, 0.4});
  const Covering covering = cover(geometry, {{Box{{0.101, 0.101, 0.21}}, at(0.0, 0.0, 0.2)},
                                             {Box{{0.101, 0.101, 0.21}}, at(0.0, 0.0, -0.2)}});
  EXPECT_TRUE(covering.is_proven);
  EXPECT_EQ(covering.widening, 0.0);
}

TEST(Covering, twoHalvesThatOnlyTouch_areGrownALittle) {
  const Covering covering = cover(
      test::boxMesh({0.1, 0.1, 0.4}),
      {{Box{{0.1, 0.1, 0.2}}, at(0.0, 0.0, 0.2)}, {Box{{0.1, 0.1, 0.2}}, at(0.0, 0.0, -0.2)}});
  EXPECT_TRUE(covering.is_proven);
  EXPECT_GT(covering.widening, 0.0);
  EXPECT_LE(covering.widening, kTolerance);
}

TEST(Covering, gapBetweenShapesThatHoldEveryVertex_isFound) {
  // All corners are in one of the two, the middle of the long sides in neither.
  const Covering covering =
      cover(test::boxMesh({0.1, 0.1, 0.4}), {{Box{{0.11, 0.11, 0.15}}, at(0.0, 0.0, 0.3)},
                                             {Box{{0.11, 0.11, 0.15}}, at(0.0, 0.0, -0.3)}});
  EXPECT_FALSE(covering.is_proven);
  EXPECT_GT(covering.excess, 0.0);
  EXPECT_LE(covering.excess, 0.15 + 1e-12) << "the gap is 0.3 m wide";
  EXPECT_LT(std::abs(covering.farthest.z()), 0.15);
}

TEST(Covering, roundGeometryInOneShape_isExact) {
  EXPECT_TRUE(cover(Sphere{0.1}, {{Sphere{0.1}, {}}}).is_proven);
  EXPECT_TRUE(cover(Sphere{0.1}, {{Box{{0.1, 0.1, 0.1}}, {}}}).is_proven);
  EXPECT_TRUE(cover(Capsule{0.2, 0.1}, {{Capsule{0.2, 0.1}, {}}}).is_proven);
  EXPECT_TRUE(cover(Capsule{0.2, 0.1}, {{Box{{0.1, 0.1, 0.3}}, {}}}).is_proven);
  const Covering covering = cover(Capsule{0.2, 0.1}, {{Capsule{0.2, 0.098}, {}}});
  EXPECT_FALSE(covering.is_proven);
  EXPECT_NEAR(covering.excess, 0.002, 1e-12);
}

TEST(Covering, cylinder_fitsTheCapsuleAndTheBoxAroundIt) {
  const Cylinder cylinder{0.2, 0.1};
  EXPECT_TRUE(cover(cylinder, {{Box{{0.1, 0.1, 0.2}}, {}}}).is_proven);
  EXPECT_TRUE(cover(cylinder, {{Sphere{std::hypot(0.1, 0.2)}, {}}}).is_proven);
  EXPECT_FALSE(cover(cylinder, {{Capsule{0.2, 0.0999}, {}}}).is_proven);
  EXPECT_FALSE(cover(cylinder, {{Box{{0.1, 0.0999, 0.2}}, {}}}).is_proven);
}

TEST(Covering, roundGeometryInSeveralShapes_needsOneHundredthMore) {
  const std::vector<PosedShape> halves{{Box{{0.102, 0.102, 0.2}}, at(0.0, 0.0, 0.15)},
                                       {Box{{0.102, 0.102, 0.2}}, at(0.0, 0.0, -0.15)}};
  EXPECT_TRUE(cover(Capsule{0.2, 0.1}, halves).is_proven);
}

TEST(Covering, verticesWithoutTriangles_count) {
  TriangleMesh mesh = test::boxMesh({0.1, 0.1, 0.1});
  mesh.vertices.emplace_back(0.0, 0.0, 0.5);
  const Covering covering = cover(mesh, {{Sphere{0.2}, {}}});
  EXPECT_FALSE(covering.is_proven);
  EXPECT_NEAR(covering.excess, 0.3, 1e-12);
}

TEST(Covering, severalGeometries_theWorstIsNamed) {
  const Geometry inside = Sphere{0.1};
  const Geometry outside = Sphere{0.3};
  const Geometry far_outside = Sphere{0.5};
  const Covering covering =
      proveCovering({{{}, &inside}, {{}, &outside}, {{}, &far_outside}}, {{Sphere{0.2}, {}}}, 1e-5);
  EXPECT_FALSE(covering.is_proven);
  EXPECT_EQ(covering.geometry, 2U);
  EXPECT_NEAR(covering.excess, 0.3, 1e-12);
}

TEST(Covering, noGeometry_isCovered) {
  EXPECT_TRUE(proveCovering({}, {{Sphere{0.2}, {}}}, kTolerance).is_proven);
}

}  // namespace
}  // namespace collision_monitor
