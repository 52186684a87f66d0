// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measure_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/constants.h"
#include "pictures/surface_mesh.h"
#include "support/sample_meshes.h"

namespace collision_monitor::fit_tool {
namespace {

PosedShape boxAt(const Eigen::Vector3d& half_extents, const Eigen::Vector3d& center) {
  return {Box{half_extents}, {Eigen::Matrix3d::Identity(), center}};
}

TEST(HullVolume, ofSolidsKnownByHand) {
  EXPECT_NEAR(hullVolumeOf(test::boxMesh({0.5, 1.0, 2.0})), 8.0, 1e-12);
  EXPECT_NEAR(hullVolumeOf(Cylinder{0.5, 2.0}), 4.0 * kPi, 1e-12);
  EXPECT_NEAR(hullVolumeOf(Sphere{1.0}), 4.0 / 3.0 * kPi, 1e-12);
  const TriangleMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  EXPECT_NEAR(hullVolumeOf(corner), 1.0 / 6.0, 1e-12);
}

TEST(HullVolume, ofAFlatMesh_isZero) {
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_NEAR(hullVolumeOf(flat), 0.0, 1e-15);
}

TEST(UnionVolume, countsWhatIsSharedOnce) {
  // Two cubes of 8 that share a slab of 2 x 2 x 1.
  const std::vector<PosedShape> cubes{boxAt({1, 1, 1}, {0, 0, 0}), boxAt({1, 1, 1}, {1, 0, 0})};
  EXPECT_NEAR(unionVolumeOf(cubes), 12.0, 0.12);
  EXPECT_DOUBLE_EQ(unionVolumeOf({cubes[0]}), 8.0);
}

TEST(UnionOvershoot, ofALargerBox_isThatOfItsCorners) {
  const Overshoot overshoot =
      unionOvershootOf({boxAt({1.1, 1.1, 1.1}, {0, 0, 0})}, test::boxMesh({1, 1, 1}));
  EXPECT_NEAR(overshoot.max, 0.1 * std::sqrt(3.0), 0.02 * 0.1 * std::sqrt(3.0));
  EXPECT_GT(overshoot.mean, 0.1 * (1.0 - 1e-9));
}

TEST(UnionOvershoot, whatAnotherShapeHolds_doesNotCount) {
  // The far half of a long box sticks out 1 m; a still larger one hides it and sticks out 3 m.
  const std::vector<PosedShape> shapes{boxAt({2, 1, 1}, {0, 0, 0}), boxAt({4, 4, 4}, {0, 0, 0})};
  const Overshoot both = unionOvershootOf(shapes, test::boxMesh({1, 1, 1}));
  const Overshoot large = unionOvershootOf({shapes[1]}, test::boxMesh({1, 1, 1}));
  EXPECT_DOUBLE_EQ(both.max, large.max);
  EXPECT_DOUBLE_EQ(both.mean, large.mean);
}

TEST(InnerShapes, largestOfTheElements_noneForOpenMeshes) {
  const Pose pose{Eigen::Matrix3d::Identity(), {0.0, 0.0, 5.0}};
  Link link;
  link.collisions.push_back({"cube", pose, test::boxMesh({0.2, 0.3, 0.4})});
  link.collisions.push_back({"ball", Pose(), Sphere{0.1}});
  TriangleMesh open_cube = test::boxMesh({1, 1, 1});
  open_cube.triangles.pop_back();
  link.collisions.push_back({"open", Pose(), open_cube});
  const InnerShapes both = innerShapesOf(link, {0, 1});
  EXPECT_NEAR(radiusOf(both.sphere->shape), 0.2, 1e-4);
  EXPECT_NEAR(both.sphere->geometry_from_body.translation.z(), 5.0, 0.2 + 1e-4);  // of 0.4
  EXPECT_GE(volumeOf(both.capsule->shape), volumeOf(both.sphere->shape));
  EXPECT_NEAR(radiusOf(innerShapesOf(link, {1}).sphere->shape), 0.1, 1e-6);
  EXPECT_FALSE(innerShapesOf(link, {2}).sphere);
}

/// The volume that a closed surface bounds, outward triangles.
double volumeInside(const TriangleMesh& mesh) {
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    Eigen::Matrix3d corners;
    corners << mesh.vertices[a], mesh.vertices[b], mesh.vertices[c];
    six_volumes += corners.determinant();
  }
  return six_volumes / 6.0;
}

TEST(SurfaceMesh, ofEveryGeometry_isOutwardAndBoundsItsVolume) {
  for (const Geometry& geometry : {Geometry(Sphere{0.3}), Geometry(Capsule{0.5, 0.2}),
                                   Geometry(Cylinder{0.4, 0.1}), Geometry(Box{{0.1, 0.2, 0.3}})}) {
    const double volume = hullVolumeOf(geometry);
    EXPECT_NEAR(volumeInside(surfaceMeshOf(geometry)), volume, 0.002 * volume) << geometry.index();
  }
}

}  // namespace
}  // namespace collision_monitor::fit_tool
