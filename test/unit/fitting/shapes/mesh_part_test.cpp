// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/mesh_part.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

double areaOf(const MeshPart& part, const TriangleMesh& mesh) {
  const auto areaOfThree = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return 0.5 * (b - a).cross(c - a).norm();
  };
  double area = 0.0;
  for (const auto i : part.triangles) {
    const auto& t = mesh.triangles[i];
    area += areaOfThree(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  std::size_t first = 0;
  for (const auto end : part.end) {
    for (std::size_t i = first + 1; i + 1 < end; ++i) {
      area += areaOfThree(part.corners[first], part.corners[i], part.corners[i + 1]);
    }
    first = end;
  }
  return area;
}

TEST(PartedSurface, slantedCuts_keepTheAreaAndTheSides) {
  const TriangleMesh mesh = test::sphereMesh(0.2, 24);
  PartedSurface surface(mesh);
  const MeshPart whole = surface.whole();
  const CutPlane first{Vector3d(1, 2, -1).normalized(), 0.03};
  const CutPlane second{Vector3d(0, 1, 1).normalized(), -0.02};
  MeshPart below;
  MeshPart above;
  surface.split(whole, first, below, above);
  MeshPart low;
  MeshPart high;
  surface.split(above, second, low, high);
  EXPECT_NEAR(areaOf(below, mesh) + areaOf(low, mesh) + areaOf(high, mesh), areaOf(whole, mesh),
              1e-12);
  for (const auto& corner : surface.cornersOf(below)) {
    EXPECT_LE(first.heightOf(corner), 1e-15);
  }
  for (const auto& corner : surface.cornersOf(low)) {
    EXPECT_GE(first.heightOf(corner), -1e-15);
    EXPECT_LE(second.heightOf(corner), 1e-15);
  }
}

TEST(PartedSurface, planeThroughAFace_putsItBelow) {
  const TriangleMesh mesh = test::boxMesh({0.1, 0.1, 0.1});
  PartedSurface surface(mesh);
  MeshPart below;
  MeshPart above;
  surface.split(surface.whole(), {Vector3d::UnitX(), 0.1}, below, above);
  EXPECT_EQ(below.triangles.size(), 12u);
  EXPECT_TRUE(above.triangles.empty());
  EXPECT_TRUE(above.end.empty());
}

TEST(PartedSurface, vertexWithoutTriangle_isAPartToo) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}};
  PartedSurface surface(mesh);
  MeshPart below;
  MeshPart above;
  surface.split(surface.whole(), {Vector3d::UnitX(), 3.0}, below, above);
  EXPECT_EQ(surface.cornersOf(below).size(), 3u);
  ASSERT_EQ(surface.cornersOf(above).size(), 1u);
  EXPECT_EQ(surface.cornersOf(above).front(), Vector3d(5, 5, 5));
}

}  // namespace
}  // namespace collision_monitor
