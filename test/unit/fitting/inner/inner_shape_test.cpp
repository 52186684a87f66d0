// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/inner_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::boxMesh;

double sphereRadius(const InnerShapes& inner) {
  return std::get<Sphere>(inner.sphere.value().shape).radius;
}

const Capsule& capsuleOf(const InnerShapes& inner) {
  return std::get<Capsule>(inner.capsule.value().shape);
}

bool isEmpty(const InnerShapes& inner) { return !inner.sphere && !inner.capsule; }

/// A prism over the L of the squares [0,1]^2, [1,2]x[0,1] and [0,1]x[1,2], 1 high.
TriangleMesh angleMesh() {
  const double corners[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& corner : corners) {
      mesh.vertices.emplace_back(corner[0], corner[1], z);
    }
  }
  for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    mesh.triangles.push_back({i, next, i + 6});
    mesh.triangles.push_back({next, next + 6, i + 6});
  }
  return mesh;
}

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TriangleMesh insideOut(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

TEST(InscribeShapes, cube_hasItsInscribedSphere) {
  const InnerShapes inner =
      inscribeShapes(test::moved(boxMesh({1, 1, 1}), {0.3, 0.2, 0.1}, {5, 6, 7}));
  EXPECT_NEAR(sphereRadius(inner), 1.0, 1e-3);
  EXPECT_LE(sphereRadius(inner), 1.0);
  EXPECT_LT((inner.sphere->geometry_from_body.translation - Eigen::Vector3d(5, 6, 7)).norm(), 2e-3);
}

TEST(InscribeShapes, tetrahedron_hasTheSphereOfItsFourFaces) {
  // Radius = 3 V / area = (1/2) / (3/2 + sqrt(3)/2), touching the coordinate planes.
  const double radius = 1.0 / (3.0 + std::sqrt(3.0));
  const InnerShapes inner = inscribeShapes(tetrahedron());
  EXPECT_NEAR(sphereRadius(inner), radius, 1e-3 * radius);
  EXPECT_LE(sphereRadius(inner), radius);
}

TEST(InscribeShapes, angle_hasItsSphereInTheCorner_wherePlanesDoNotMeet) {
  // Heights allow 0.5. The inner edge (1, 1) is sqrt(2)/2 from (0.5, 0.5): no constraint.
  const InnerShapes inner = inscribeShapes(angleMesh());
  EXPECT_NEAR(sphereRadius(inner), 0.5, 1e-3);
  EXPECT_LE(sphereRadius(inner), 0.5);
  // A capsule of radius 0.5 fits along either arm, from 0.5 to 1.5.
  const double arm = volumeOf(Capsule{0.5, 0.5});
  EXPECT_GT(volumeOf(capsuleOf(inner)), 0.9 * arm);
}

TEST(InscribeShapes, longBox_hasACapsuleAlongIt) {
  const InnerShapes inner = inscribeShapes(boxMesh({3, 0.5, 0.5}));
  EXPECT_GT(volumeOf(capsuleOf(inner)), 0.95 * volumeOf(Capsule{2.5, 0.5}));
  EXPECT_LE(capsuleOf(inner).radius, 0.5);
  EXPECT_GT(std::abs(inner.capsule->geometry_from_body.rotation(0, 2)), 0.99);
}

TEST(InscribeShapes, insideOutCube_isTurned) {
  EXPECT_NEAR(sphereRadius(inscribeShapes(insideOut(boxMesh({1, 1, 1})))), 1.0, 1e-3);
}

TEST(InscribeShapes, hollowCube_holdsItsSphereInTheWall) {
  // The wall is from 1 to 3, but the cavity is a cube: a corner of the wall gives more than the
  // half thickness 1: center (c, c, c) with (c - 1) sqrt(3) = 3 - c.
  const TriangleMesh hollow = test::joined(boxMesh({3, 3, 3}), insideOut(boxMesh({1, 1, 1})));
  const double center = (3.0 + std::sqrt(3.0)) / (1.0 + std::sqrt(3.0));
  const InnerShapes inner = inscribeShapes(hollow);
  EXPECT_LE(sphereRadius(inner), 3.0 - center);
  EXPECT_GT(sphereRadius(inner), 0.99 * (3.0 - center));
  EXPECT_GT(inner.sphere->geometry_from_body.translation.cwiseAbs().maxCoeff(), 1.0);
}

TEST(InscribeShapes, cubeInACube_isNotTrustedWhereBothAre) {
  // Winding number 2 inside: a cavity turned the wrong way looks the same.
  const TriangleMesh nested = test::joined(boxMesh({3, 3, 3}), boxMesh({1, 1, 1}));
  const InnerShapes inner = inscribeShapes(nested);
  EXPECT_GT(inner.sphere->geometry_from_body.translation.cwiseAbs().maxCoeff(), 1.0);
}

TEST(InscribeShapes, openCube_hasNone) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.triangles.pop_back();
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
}

TEST(InscribeShapes, selfContradictingCube_hasNone) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
  mesh = boxMesh({1, 1, 1});
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
}

TEST(InscribeShapes, cubeOfLooseTriangles_isClosedByEqualVertices) {
  const TriangleMesh cube = boxMesh({1, 1, 1});
  TriangleMesh loose;
  for (const auto& t : cube.triangles) {
    for (const auto corner : t) {
      loose.vertices.push_back(cube.vertices[corner]);
    }
    const auto last = static_cast<std::uint32_t>(loose.vertices.size());
    loose.triangles.push_back({last - 3, last - 2, last - 1});
  }
  EXPECT_NEAR(sphereRadius(inscribeShapes(loose)), 1.0, 1e-3);
}

TEST(InscribeShapes, sameMesh_givesTheSameBytes) {
  const InnerShapes one = inscribeShapes(angleMesh());
  const InnerShapes two = inscribeShapes(angleMesh());
  EXPECT_EQ(sphereRadius(one), sphereRadius(two));
  EXPECT_EQ(one.capsule->geometry_from_body.rotation, two.capsule->geometry_from_body.rotation);
  EXPECT_EQ(capsuleOf(one).half_length, capsuleOf(two).half_length);
}

TEST(InscribeShapes, flatMeshesTrianglesAndPoints_haveNone) {
  EXPECT_TRUE(isEmpty(inscribeShapes(boxMesh({1, 1, 0}))));
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
  mesh.triangles.push_back({0, 2, 1});
  EXPECT_TRUE(isEmpty(inscribeShapes(mesh)));
}

TEST(InscribeShapes, scale_changesNothingButTheScale) {
  for (const double scale : {1e-6, 1e6}) {
    const double radius = sphereRadius(inscribeShapes(test::scaled(tetrahedron(), scale)));
    EXPECT_NEAR(radius, scale / (3.0 + std::sqrt(3.0)), 1e-3 * scale);
  }
}

TEST(InscribeShapes, primitives) {
  EXPECT_EQ(sphereRadius(inscribeShapes(Sphere{0.3})), 0.3);
  EXPECT_EQ(capsuleOf(inscribeShapes(Sphere{0.3})).half_length, 0.0);
  EXPECT_EQ(sphereRadius(inscribeShapes(Capsule{1.0, 0.3})), 0.3);
  EXPECT_EQ(capsuleOf(inscribeShapes(Capsule{1.0, 0.3})).half_length, 1.0);
  const InnerShapes box = inscribeShapes(Box{{1, 4, 2}});
  EXPECT_EQ(sphereRadius(box), 1.0);
  EXPECT_NEAR(capsuleOf(box).half_length, 3.0, 1e-14);
  EXPECT_LE(capsuleOf(box).half_length, 3.0);
  EXPECT_EQ(box.capsule->geometry_from_body.rotation.col(2), Eigen::Vector3d(0, 1, 0));
  EXPECT_TRUE(isRigid(box.capsule->geometry_from_body));
  const InnerShapes rod = inscribeShapes(Cylinder{2.0, 0.5});
  EXPECT_EQ(sphereRadius(rod), 0.5);
  EXPECT_NEAR(capsuleOf(rod).half_length, 1.5, 1e-14);
  const InnerShapes disc = inscribeShapes(Cylinder{0.5, 2.0});
  EXPECT_EQ(capsuleOf(disc).radius, 0.5);
  EXPECT_NEAR(capsuleOf(disc).half_length, 1.5, 1e-14);
  EXPECT_EQ(disc.capsule->geometry_from_body.rotation.col(2), Eigen::Vector3d(1, 0, 0));
  EXPECT_TRUE(isEmpty(inscribeShapes(Sphere{0.0})));
  EXPECT_TRUE(isEmpty(inscribeShapes(Box{{1, 1, 0}})));
}

TEST(InscribeShapes, badInput_isRefused) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(inscribeShapes(mesh), std::invalid_argument);
  mesh = boxMesh({1, 1, 1});
  mesh.triangles[0][0] = 99;
  EXPECT_THROW(inscribeShapes(mesh), std::invalid_argument);
  EXPECT_THROW(inscribeShapes(TriangleMesh{}), std::invalid_argument);
  EXPECT_THROW(inscribeShapes(Sphere{-1.0}), std::invalid_argument);
  EXPECT_THROW(inscribeShapes(Box{{1, std::numeric_limits<double>::infinity(), 1}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace collision_monitor
