// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/winding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "geometry/constants.h"
#include "support/instruction_sets.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test::winding {
namespace {

using Eigen::Vector3d;

constexpr double kExact = 1e-14;

double windingOfAll(const TriangleMesh& mesh, const Vector3d& point) {
  SolidAngles angles(point);
  for (const auto& t : mesh.triangles) {
    angles.add({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  return angles.sum() / (4.0 * kPi);
}

double solidAngle(const Triangle& triangle, const Vector3d& point) {
  SolidAngles angles(point);
  angles.add(triangle);
  return angles.sum();
}

/// A box whose last side, of two triangles, is missing.
TriangleMesh withoutOneSide(TriangleMesh box) {
  box.triangles.resize(box.triangles.size() - 2);
  return box;
}

TEST(SolidAngle, octant_isAnEighthOfAllDirections) {
  const Triangle octant = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
  EXPECT_NEAR(solidAngle(octant, Vector3d::Zero()), 0.5 * kPi, kExact);
  EXPECT_NEAR(solidAngle({octant[0], octant[2], octant[1]}, Vector3d::Zero()), -0.5 * kPi, kExact);
  // From far off, the area seen over the squared distance.
  const double far = solidAngle(octant, Vector3d(-1e3, -1e3, -1e3));
  EXPECT_NEAR(far * 3.0e6, 0.5 * std::sqrt(3.0), 1e-3);
}

TEST(SolidAngle, surfacesThatGoAroundManyTimes_areCounted) {
  const TriangleMesh box = boxMesh({1, 2, 3});
  TriangleMesh often = box;
  for (int i = 1; i < 500; ++i) {
    often.triangles.insert(often.triangles.end(), box.triangles.begin(), box.triangles.end());
  }
  EXPECT_NEAR(windingOfAll(often, Vector3d(0.1, 0.2, 0.3)), 500.0, 1e-10);
  EXPECT_NEAR(windingOfAll(often, Vector3d(0, 0, 0)), 500.0, 1e-10);
  EXPECT_NEAR(windingOfAll(often, Vector3d(1.5, 0.2, 0.3)), 0.0, 1e-10);
  for (auto& triangle : often.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_NEAR(windingOfAll(often, Vector3d(0.1, 0.2, 0.3)), -500.0, 1e-10);
}

TEST(SolidAngle, everyInstructionSet_givesTheSameBytes) {
  const TriangleMesh mesh = withoutOneSide(boxMesh({1, 2, 3}));
  const Vector3d point(0.1, 0.2, 0.3);
  const double expected = windingOfAll(mesh, point);
  for (const std::int64_t target : instructionSets()) {
    const OnlyInstructionSet only(target);
    EXPECT_EQ(windingOfAll(mesh, point), expected) << hwy::TargetName(target);
  }
}

TEST(SolidAngle, trianglesWithoutArea_coverNothing) {
  const Vector3d point(0.1, 0.2, 0.3);
  EXPECT_EQ(solidAngle({Vector3d::UnitX(), Vector3d::UnitX(), Vector3d::UnitX()}, point), 0.0);
  EXPECT_NEAR(solidAngle({Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitY()}, point), 0.0,
              kExact);
}

TEST(SolidAngle, cubeWithoutOneSide_fiveSixthsInTheMiddle) {
  EXPECT_NEAR(windingOfAll(boxMesh({1, 1, 1}), Vector3d::Zero()), 1.0, kExact);
  EXPECT_NEAR(windingOfAll(withoutOneSide(boxMesh({1, 1, 1})), Vector3d::Zero()), 5.0 / 6.0,
              kExact);
}

TEST(WindingMoments, ofATriangle) {
  const WindingMoments found = momentsOf({Vector3d(0, 0, 2), Vector3d(3, 0, 2), Vector3d(0, 6, 2)});
  EXPECT_TRUE(found.center.isApprox(Vector3d(1, 2, 2), kExact));
  EXPECT_TRUE(found.normal.isApprox(Vector3d(0, 0, 9), kExact));
  EXPECT_NEAR(found.area, 9.0, kExact);
  EXPECT_NEAR(found.radius, std::sqrt(17.0), kExact);
  // Of a triangle about its middle: area / 12 times the squares of the ways to its corners.
  EXPECT_NEAR(found.squared, 9.0 / 12.0 * (5.0 + 8.0 + 17.0), 1e-13);
}

TEST(WindingMoments, joinedParts_areOffByNoMoreThanIsTold) {
  const TriangleMesh box = withoutOneSide(boxMesh({0.1, 0.2, 0.3}));
  WindingMoments all;
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    const auto& t = box.triangles[i];
    const WindingMoments part =
        momentsOf({box.vertices[t[0]], box.vertices[t[1]], box.vertices[t[2]]});
    all = i == 0 ? part : joined(all, part);
  }
  for (const double away : {0.5, 1.0, 2.0, 8.0}) {
    for (const Vector3d& side : {Vector3d(1, 0, 0), Vector3d(0, 0.6, -0.8), Vector3d(0, 0, 1)}) {
      const Vector3d point = all.center + away * side;
      const BoundedNumber found = windingOf(all, point);
      const double off = std::abs(found.value - windingOfAll(box, point));
      EXPECT_LE(off, found.error);
      EXPECT_GT(off, 1e-9) << "the bound is put to a test";
    }
  }
  EXPECT_EQ(windingOf(all, all.center).error, kInfinity) << "in the ball about the part";
}

TEST(OrientedSurface, triangleTurnedOver_isTurnedBack) {
  TriangleMesh box = boxMesh({1, 2, 3});
  const TriangleMesh sound = box;
  std::swap(box.triangles[3][1], box.triangles[3][2]);
  std::swap(box.triangles[8][0], box.triangles[8][1]);
  const TriangleMesh turned = orientedSurface(box);
  EXPECT_NEAR(windingOfAll(box, Vector3d(0.1, 0, 0)), 2.0 / 3.0, 0.2)
      << "or there is nothing to do";
  EXPECT_NEAR(windingOfAll(turned, Vector3d(0.1, 0, 0)), 1.0, kExact);
  EXPECT_EQ(orientedSurface(sound).triangles, sound.triangles);
}

TEST(OrientedSurface, meshInsideOut_staysSo) {
  TriangleMesh box = boxMesh({1, 1, 1});
  for (auto& triangle : box.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  std::swap(box.triangles[5][1], box.triangles[5][2]);
  EXPECT_NEAR(windingOfAll(orientedSurface(box), Vector3d::Zero()), -1.0, kExact);
}

TEST(OrientedSurface, trianglesOfTwoSides_countOnce) {
  TriangleMesh box = boxMesh({1, 1, 1});
  const std::size_t count = box.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = box.triangles[i];
    box.triangles.push_back({t[2], t[1], t[0]});
  }
  ASSERT_NEAR(windingOfAll(box, Vector3d::Zero()), 0.0, kExact);
  const TriangleMesh once = orientedSurface(box);
  EXPECT_EQ(once.triangles.size(), box.triangles.size());
  EXPECT_NEAR(windingOfAll(once, Vector3d::Zero()), 1.0, kExact);
}

/// [m] Of all sides at which a surface ends.
double rimLength(const TriangleMesh& mesh) {
  const std::vector<std::uint8_t> rim = rimSidesOf(mesh);
  double length = 0.0;
  for (std::size_t t = 0; t < rim.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      length += (rim[t] >> i & 1U) != 0
                    ? (mesh.vertices[corners[(i + 1) % 3]] - mesh.vertices[corners[i]]).norm()
                    : 0.0;
    }
  }
  return length;
}

TEST(SurfaceRim, ofABoxWithoutOneSide_isThatSidesEdges) {
  EXPECT_NEAR(rimLength(withoutOneSide(boxMesh({1, 1, 1}))), 8.0, kExact);
  EXPECT_EQ(rimLength(boxMesh({1, 1, 1})), 0.0);
}

TEST(SurfaceRim, trianglesThatRunTheSameWay_endOnceEach) {
  TriangleMesh sheets;
  sheets.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  sheets.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};  // the first edge twice, and once back
  const std::vector<std::uint8_t> rim = rimSidesOf(sheets);
  EXPECT_EQ((rim[0] & 1U) + (rim[1] & 1U) + (rim[2] & 1U), 1U);
  EXPECT_EQ(rim[0] & 6U, 6U);
  EXPECT_EQ(rim[1] & 6U, 6U);
  EXPECT_EQ(rim[2] & 6U, 6U);
}

TEST(SurfaceRim, equalVertices_areOne) {
  TriangleMesh loose;
  const TriangleMesh box = boxMesh({1, 1, 1});
  for (const auto& triangle : box.triangles) {
    const auto first = static_cast<std::uint32_t>(loose.vertices.size());
    for (const auto corner : triangle) {
      loose.vertices.push_back(box.vertices[corner]);
    }
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(rimLength(loose), 0.0);
}

}  // namespace
}  // namespace collision_monitor::test::winding
