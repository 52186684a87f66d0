// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/enclose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fitting/proofs/proof.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::boxMesh;
using test::moved;
using test::prismMesh;
using test::randomCloud;
using test::scaled;
using test::sphereMesh;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expectEncloses(const TriangleMesh& mesh, const Enclosure& enclosure) {
  const PosedShape fit{enclosure.shape, enclosure.geometry_from_body};
  EXPECT_LE(provenExcess(fit, mesh.vertices), 0.0);
  EXPECT_TRUE(isRigid(enclosure.geometry_from_body, 1e-12));
  EXPECT_FALSE(enclosure.is_exact);
  EXPECT_GE(enclosure.overshoot.max, enclosure.overshoot.mean);
  EXPECT_GE(enclosure.overshoot.mean, 0.0);
  double size = 0.0;
  for (const auto& vertex : mesh.vertices) {
    size = std::max(size, vertex.norm());
  }
  EXPECT_LE(enclosure.widening, 1e-13 * size + 1e-100);
}

std::string messageOf(const Geometry& geometry) {
  try {
    encloseTightly(geometry);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Enclose, sphereCapsuleAndBox_passThroughExactly) {
  const Enclosure sphere = encloseTightly(Sphere{0.3});
  EXPECT_TRUE(sphere.is_exact);
  EXPECT_EQ(std::get<Sphere>(sphere.shape).radius, 0.3);
  const Enclosure capsule = encloseTightly(Capsule{0.2, 0.1});
  EXPECT_TRUE(capsule.is_exact);
  EXPECT_EQ(std::get<Capsule>(capsule.shape).half_length, 0.2);
  const Enclosure box = encloseTightly(Box{{0.1, 0.2, 0.0}});
  EXPECT_TRUE(box.is_exact);
  EXPECT_EQ(std::get<Box>(box.shape).half_extents, Vector3d(0.1, 0.2, 0.0));
  EXPECT_EQ(box.overshoot.max, 0.0);
  EXPECT_EQ(box.geometry_from_body.rotation, Eigen::Matrix3d::Identity());
}

TEST(Enclose, turnedBoxMesh_isThatBox) {
  const TriangleMesh mesh = moved(boxMesh({0.1, 0.2, 0.3}), {0.3, -0.5, 0.9}, {1.0, -2.0, 0.5});
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_STREQ(kindName(enclosure.shape), "box");
  EXPECT_NEAR(volumeOf(enclosure.shape), 8 * 0.1 * 0.2 * 0.3, 1e-8);
  EXPECT_LT(enclosure.overshoot.max, 1e-6);
}

TEST(Enclose, fineSphereMesh_isASphere) {
  const TriangleMesh mesh = moved(sphereMesh(0.25, 32), {1.0, 0.2, 0.0}, {0.0, 0.0, 3.0});
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_STREQ(kindName(enclosure.shape), "sphere");
  EXPECT_NEAR(radiusOf(enclosure.shape), 0.25, 1e-9);
  // A chord of 360 / 32 degrees sags by r (1 - cos(5.6 deg)) in both directions of the grid.
  EXPECT_LT(enclosure.overshoot.max, 2.0 * 0.25 * (1.0 - std::cos(3.14159 / 32)) + 1e-4);
}

TEST(Enclose, longRoundTube_isACapsule) {
  const TriangleMesh mesh = prismMesh(0.01, 0.6, 24);
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_STREQ(kindName(enclosure.shape), "capsule");
  EXPECT_NEAR(std::abs(enclosure.geometry_from_body.rotation(2, 2)), 1.0, 1e-3);
}

TEST(Enclose, flatMesh_isABoxWithoutThickness) {
  const TriangleMesh mesh =
      moved({{{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.2, 0}, {0, 0.2, 0}}, {{0, 1, 2}, {0, 2, 3}}},
            {0.7, 0.1, -0.4}, {0.1, 0.1, 0.1});
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_LT(enclosure.overshoot.max, 1e-5);
  EXPECT_LT(coreHalfExtents(enclosure.shape).minCoeff(), 1e-6);
}

TEST(Enclose, oneTriangle_isHeld) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  // The flat square around it reaches 0.71 beyond at one corner.
  EXPECT_LT(enclosure.overshoot.max, 0.71);
}

TEST(Enclose, collinearMesh_isASegment) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_LT(enclosure.overshoot.max, 1e-5);
}

TEST(Enclose, onePoint_isAPoint) {
  const TriangleMesh mesh{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}};
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_EQ(enclosure.geometry_from_body.translation, Vector3d(1, 2, 3));
  EXPECT_LT(radiusOf(enclosure.shape), 1e-100);
}

TEST(Enclose, scale_changesTheSizeAndNothingElse) {
  const TriangleMesh mesh = moved(boxMesh({0.1, 0.25, 0.3}), {0.3, -0.5, 0.9}, {1.0, -2.0, 0.5});
  for (const double factor : {1e-6, 1e6}) {
    const TriangleMesh other = scaled(mesh, factor);
    const Enclosure enclosure = encloseTightly(other);
    expectEncloses(other, enclosure);
    EXPECT_NEAR(volumeOf(enclosure.shape) / std::pow(factor, 3), 8 * 0.1 * 0.25 * 0.3, 1e-6);
  }
}

TEST(Enclose, insideOutOpenAndCrossing_makeNoDifferenceToTheShape) {
  const TriangleMesh mesh = moved(boxMesh({0.1, 0.2, 0.3}), {0.3, -0.5, 0.9}, {1.0, -2.0, 0.5});
  const Enclosure reference = encloseTightly(mesh);
  TriangleMesh inside_out = mesh;
  for (auto& triangle : inside_out.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const Enclosure flipped = encloseTightly(inside_out);
  EXPECT_EQ(volumeOf(flipped.shape), volumeOf(reference.shape));
  EXPECT_NEAR(flipped.overshoot.mean, reference.overshoot.mean, 1e-12);
  TriangleMesh open = mesh;
  open.triangles.resize(10);  // without the side +x
  expectEncloses(open, encloseTightly(open));
  TriangleMesh crossing = mesh;
  crossing.triangles.push_back({0, 7, 3});
  expectEncloses(crossing, encloseTightly(crossing));
}

TEST(Enclose, sameMesh_sameBytes) {
  const TriangleMesh mesh = randomCloud({0.1, 0.2, 0.3}, 200, 4);
  const Enclosure first = encloseTightly(mesh);
  const Enclosure second = encloseTightly(mesh);
  EXPECT_EQ(first.shape.index(), second.shape.index());
  EXPECT_EQ(coreHalfExtents(first.shape), coreHalfExtents(second.shape));
  EXPECT_EQ(first.geometry_from_body.rotation, second.geometry_from_body.rotation);
  EXPECT_EQ(first.overshoot.mean, second.overshoot.mean);
}

TEST(Enclose, million_trianglesAreHeld) {
  const TriangleMesh mesh = sphereMesh(0.5, 1000);
  ASSERT_EQ(mesh.triangles.size(), 1000000u);
  const Enclosure enclosure = encloseTightly(mesh);
  expectEncloses(mesh, enclosure);
  EXPECT_NEAR(volumeOf(enclosure.shape), 4.0 / 3.0 * 3.14159265 * 0.125, 1e-4);
}

TEST(Enclose, badMeshes_areErrorsThatNameTheFault) {
  EXPECT_EQ(messageOf(TriangleMesh{}), "mesh: no vertices; at least one is needed");
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.vertices[2].y() = kNan;
  EXPECT_EQ(messageOf(mesh),
            "mesh: vertex 2 is (-1, nan, -1); coordinates up to 1e+100 are accepted");
  mesh.vertices[2].y() = 1e200;
  EXPECT_EQ(messageOf(mesh),
            "mesh: vertex 2 is (-1, 1e+200, -1); coordinates up to 1e+100 are accepted");
}

TEST(Enclose, badDimensions_areErrorsThatNameTheFault) {
  EXPECT_EQ(messageOf(Sphere{-0.1}),
            "sphere radius is -0.1; a number from 0 to 1e+100 is accepted");
  EXPECT_EQ(messageOf(Capsule{kNan, 0.1}),
            "capsule half length is nan; a number from 0 to 1e+100 is accepted");
  EXPECT_EQ(messageOf(Box{{0.1, -1.0, 0.1}}),
            "box half extent along y is -1; a number from 0 to 1e+100 is accepted");
  EXPECT_EQ(messageOf(Cylinder{0.1, std::numeric_limits<double>::infinity()}),
            "cylinder radius is inf; a number from 0 to 1e+100 is accepted");
}

}  // namespace
}  // namespace collision_monitor
