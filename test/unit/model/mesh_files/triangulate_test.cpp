// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace collision_monitor {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

Eigen::Vector3d areaVector(const Polygon& p, const std::array<std::uint32_t, 3>& t) {
  return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

double areaOf(const Polygon& polygon) {
  double area = 0.0;
  for (const auto& triangle : triangulate(polygon)) {
    area += areaVector(polygon, triangle).norm();
  }
  return area;
}

/// An L of area 3 that fills three quarters of a square of 2 x 2.
const Polygon kNotched{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

TEST(Triangulate, square_isTwoTriangles) {
  const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(square).size(), 2u);
  EXPECT_DOUBLE_EQ(areaOf(square), 1.0);
}

TEST(Triangulate, notchedPolygon_staysNotched) {
  EXPECT_EQ(triangulate(kNotched).size(), 4u);
  EXPECT_DOUBLE_EQ(areaOf(kNotched), 3.0);
}

TEST(Triangulate, anyStart_anyWay_anyPlane_givesTheSameArea) {
  Polygon polygon = kNotched;
  for (Eigen::Vector3d& corner : polygon) {
    corner = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()) * corner +
             Eigen::Vector3d(4, 5, 6);
  }
  for (std::size_t start = 0; start < polygon.size(); ++start) {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    EXPECT_NEAR(areaOf(polygon), 3.0, 1e-12);
    std::reverse(polygon.begin(), polygon.end());
    EXPECT_NEAR(areaOf(polygon), 3.0, 1e-12);
  }
}

TEST(Triangulate, winding_staysThatOfThePolygon) {
  for (const auto& triangle : triangulate(kNotched)) {
    EXPECT_GE(areaVector(kNotched, triangle).z(), 0.0);
  }
  const Polygon reversed(kNotched.rbegin(), kNotched.rend());
  for (const auto& triangle : triangulate(reversed)) {
    EXPECT_LE(areaVector(reversed, triangle).z(), 0.0);
  }
}

TEST(Triangulate, squareWithAHoleJoinedByABridge_keepsTheHole) {
  // Outline, bridge to the hole at (1,1), hole clockwise, and back over the bridge.
  const Polygon ring{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                     {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  EXPECT_DOUBLE_EQ(areaOf(ring), 8.0);
}

TEST(Triangulate, tinyPolygon_losesNothing) {
  Polygon polygon = kNotched;
  for (Eigen::Vector3d& corner : polygon) {
    corner *= 1e-4;
  }
  EXPECT_NEAR(areaOf(polygon), 3e-8, 1e-20);
}

TEST(Triangulate, bowTie_coversBothLobes) {
  // Crosses itself at (1, 1); a point deep in each lobe must be covered.
  const Polygon bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.2, 1, 0), Eigen::Vector3d(1.8, 1, 0)}) {
    bool is_covered = false;
    for (const auto& t : triangulate(bow)) {
      const double sign = areaVector(bow, t).z() < 0.0 ? -1.0 : 1.0;
      bool is_inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& a = bow[t[i]];
        is_inside &= sign * (bow[t[(i + 1) % 3]] - a).cross(point - a).z() >= 0.0;
      }
      is_covered |= is_inside;
    }
    EXPECT_TRUE(is_covered) << point.transpose();
  }
}

TEST(Triangulate, cornersOnOneLine_giveTrianglesWithoutArea) {
  EXPECT_DOUBLE_EQ(areaOf({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), 0.0);
}

}  // namespace
}  // namespace collision_monitor
