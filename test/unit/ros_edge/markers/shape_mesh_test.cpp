// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/shape_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor::test {
namespace {

/// By the divergence theorem; negative if the triangles face inwards, too small if some are
/// missing.
double enclosedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

/// Areas times normals of a closed surface cancel.
Eigen::Vector3d sumOfAreas(const TriangleMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& corner = mesh.vertices[t[0]];
    sum += 0.5 * (mesh.vertices[t[1]] - corner).cross(mesh.vertices[t[2]] - corner);
  }
  return sum;
}

class ShapeMesh : public testing::TestWithParam<Shape> {};

TEST_P(ShapeMesh, verticesLieALittleOutside) {
  const double most = std::max(2e-3, 0.02 * radiusOf(GetParam()));
  for (const Eigen::Vector3d& vertex : surfaceOf(GetParam()).vertices) {
    EXPECT_GE(signedDistanceTo(GetParam(), vertex), -1e-12);
    EXPECT_LE(signedDistanceTo(GetParam(), vertex), most);
  }
}

TEST_P(ShapeMesh, middlesLieALittleInside) {
  const double most = std::max(2e-3, 0.02 * radiusOf(GetParam()));
  const TriangleMesh mesh = surfaceOf(GetParam());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d middle =
        (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    EXPECT_NEAR(signedDistanceTo(GetParam(), middle), 0.0, most);
  }
}

TEST_P(ShapeMesh, surfaceIsClosedAndFacesOutwards) {
  const TriangleMesh mesh = surfaceOf(GetParam());
  EXPECT_LT(sumOfAreas(mesh).norm(), 1e-9);
  EXPECT_NEAR(enclosedVolume(mesh), volumeOf(GetParam()), 0.05 * volumeOf(GetParam()));
}

TEST(SmallShapeMesh, hasFewTriangles) {
  const std::size_t of_large = surfaceOf(RoundedBox{{0.1, 0.2, 0.3}, 0.1}).triangles.size();
  const std::size_t of_small = surfaceOf(RoundedBox{{0.1, 0.2, 0.3}, 0.01}).triangles.size();
  EXPECT_LE(2 * of_small, of_large);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeMesh,
                         testing::Values(Shape(Sphere{0.2}), Shape(Capsule{0.3, 0.1}),
                                         Shape(Box{{0.1, 0.2, 0.3}}),
                                         Shape(RoundedBox{{0.1, 0.2, 0.3}, 0.05}),
                                         Shape(Capsule{0.1, 0.01}),
                                         Shape(RoundedBox{{0.1, 0.2, 0.0}, 0.05})));

}  // namespace
}  // namespace collision_monitor::test
