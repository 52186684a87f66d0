// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "fitting/shapes/fit_box.h"
#include "geometry/hulls/convex_hull.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::moved;
using test::prismMesh;
using test::randomCloud;

double boxVolume(const Matrix3d& axes, const Points& points) {
  Vector3d low = axes.transpose() * points[0];
  Vector3d high = low;
  for (const auto& point : points) {
    low = low.cwiseMin(axes.transpose() * point);
    high = high.cwiseMax(axes.transpose() * point);
  }
  return (high - low).prod();
}

std::vector<Vector3d> edgesOf(const TriangleMesh& hull) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& t : hull.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      pairs.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  std::vector<Vector3d> edges;
  for (const auto& [a, b] : pairs) {
    edges.push_back((hull.vertices[b] - hull.vertices[a]).normalized());
  }
  return edges;
}

/// The least box by O'Rourke's theorem (1985): two of its adjacent faces each hold an edge of the
/// hull. For every pair of edges the one angle that is left is tried in small steps. Slow.
double leastBoxVolume(const Points& points) {
  constexpr int kAngles = 180;
  const TriangleMesh hull = convexHullOf(points);
  const auto edges = edgesOf(hull);
  double least = boxVolume(Matrix3d::Identity(), hull.vertices);
  for (const auto& first : edges) {
    const Vector3d u = first.unitOrthogonal();
    const Vector3d v = first.cross(u);
    for (const auto& second : edges) {
      for (int i = 0; i < kAngles; ++i) {
        const double angle = 3.14159265358979 * i / kAngles;
        Matrix3d axes;
        axes.col(0) = std::cos(angle) * u + std::sin(angle) * v;  // across the first edge
        const Vector3d across_both = axes.col(0).cross(second);
        if (across_both.norm() < 1e-6) {
          continue;
        }
        axes.col(1) = across_both.normalized();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        least = std::min(least, boxVolume(axes, hull.vertices));
      }
    }
  }
  return least;
}

TEST(FitBox, randomClouds_areWithinOnePercentOfTheExhaustiveSearch) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const auto mesh = randomCloud({0.1 * seed, 0.3, 0.2}, 20, seed);
    const auto points = moved(mesh, {0.3 * seed, -0.2, 0.5}, {1, 0, 0}).vertices;
    EXPECT_LE(volumeOf(fitBox(points).shape), 1.01 * leastBoxVolume(points)) << "seed " << seed;
  }
}

TEST(FitBox, prismOfFiveSides_isWithinOnePercentOfTheExhaustiveSearch) {
  const auto points = moved(prismMesh(0.2, 0.3, 5), {0.5, 0.4, 0.3}, {0, 0, 0}).vertices;
  EXPECT_LE(volumeOf(fitBox(points).shape), 1.01 * leastBoxVolume(points));
}

}  // namespace
}  // namespace collision_monitor
