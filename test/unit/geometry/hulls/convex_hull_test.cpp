// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/convex_hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Points cubeCorners(double half) {
  Points corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                         (i & 4) != 0 ? half : -half);
  }
  return corners;
}

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

/// Every directed edge as often as its opposite.
bool isClosed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (opposite == edges.end() || opposite->second != count) {
      return false;
    }
  }
  return true;
}

TEST(ConvexHull, cube_hasEightCornersAndTwelveOutwardTriangles) {
  const TriangleMesh hull = convexHullOf(cubeCorners(0.5));
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.triangles.size(), 12u);
  EXPECT_TRUE(isClosed(hull));
  EXPECT_NEAR(signedVolume(hull), 1.0, 1e-12);
}

TEST(ConvexHull, pointsInsideAndDuplicates_areDropped) {
  Points points = cubeCorners(1.0);
  const Points again = points;
  points.insert(points.end(), again.begin(), again.end());
  points.emplace_back(0.0, 0.0, 0.0);
  points.emplace_back(0.9, 0.9, 0.9);
  const TriangleMesh hull = convexHullOf(points);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_NEAR(signedVolume(hull), 8.0, 1e-12);
}

TEST(ConvexHull, verticesAreInputPointsUnchanged) {
  const Points points{{0.1, 0.2, 0.3}, {1.1, 0.2, 0.3}, {0.1, 1.2, 0.3}, {0.1, 0.2, 1.3}};
  for (const auto& vertex : convexHullOf(points).vertices) {
    EXPECT_EQ(std::count(points.begin(), points.end(), vertex), 1);
  }
}

TEST(ConvexHull, scaleAndPlace_changeNothing) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const double shift : {0.0, 10.0}) {
      Points points;
      for (const auto& corner : cubeCorners(scale)) {
        points.emplace_back(corner + Vector3d::Constant(shift * scale));
      }
      const TriangleMesh hull = convexHullOf(points);
      EXPECT_EQ(hull.vertices.size(), 8u) << "scale " << scale << " shift " << shift;
      EXPECT_EQ(hull.triangles.size(), 12u) << "scale " << scale << " shift " << shift;
    }
  }
}

TEST(ConvexHull, flatSquareWithPointInside_isClosedAndTwoSided) {
  const Points points{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {0.5, 0.5, 2}, {0.5, 0.0, 2}};
  const TriangleMesh hull = convexHullOf(points);
  EXPECT_EQ(hull.vertices.size(), 4u);
  EXPECT_EQ(hull.triangles.size(), 4u);
  EXPECT_TRUE(isClosed(hull));
  EXPECT_NEAR(signedVolume(hull), 0.0, 1e-15);
}

TEST(ConvexHull, collinearPoints_giveTheTwoEnds) {
  const TriangleMesh hull = convexHullOf({{0, 0, 0}, {2, 2, 2}, {-1, -1, -1}, {1, 1, 1}});
  ASSERT_EQ(hull.vertices.size(), 2u);
  EXPECT_NEAR((hull.vertices[0] - hull.vertices[1]).norm(), 3.0 * std::sqrt(3.0), 1e-12);
  EXPECT_TRUE(hull.triangles.empty());
}

TEST(ConvexHull, onePointManyTimes_givesOneVertex) {
  const TriangleMesh hull = convexHullOf(Points(5, Vector3d(1, 2, 3)));
  ASSERT_EQ(hull.vertices.size(), 1u);
  EXPECT_EQ(hull.vertices[0], Vector3d(1, 2, 3));
}

TEST(ConvexHull, nearlyFlatSlab_isNotTakenForFlat) {
  Points points = cubeCorners(1.0);
  for (auto& point : points) {
    point.z() *= 1e-9;
  }
  const TriangleMesh hull = convexHullOf(points);
  EXPECT_EQ(hull.vertices.size(), 8u);
}

TEST(ConvexHull, noPoints_isAnError) { EXPECT_THROW(convexHullOf({}), std::invalid_argument); }

TEST(ConvexHull, notANumber_isAnErrorThatNamesThePoint) {
  Points points = cubeCorners(1.0);
  points[3].y() = std::numeric_limits<double>::quiet_NaN();
  try {
    convexHullOf(points);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("point 3"), std::string::npos) << error.what();
  }
}

TEST(ConvexHull, failureOfQhull_printsNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  convexHullOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-11}, {0.5, 0.5, 0.0}});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace collision_monitor
