// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "geometry/hulls/convex_hull.h"
#include "support/fixed_seed.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

/// Lattice points share planes and lines, which is what hulls stumble over; others do not.
std::vector<Vector3d> anyPoints() {
  const bool on_lattice = *rc::gen::inRange(0, 2) == 0;
  const double scale = std::pow(10.0, *rc::gen::inRange(-6, 7));
  const int count = *rc::gen::inRange(1, 60);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    Vector3d point(between(-2, 2), between(-2, 2), between(-2, 2));
    if (on_lattice) {
      point = point.array().round();
    }
    points.emplace_back(scale * point);
  }
  return points;
}

RC_GTEST_PROP(ConvexHullLaws, noPointIsOutside, ()) {
  const auto points = anyPoints();
  const TriangleMesh hull = convexHullOf(points);
  double size = 0.0;
  for (const auto& point : points) {
    size = std::max(size, point.norm());
  }
  for (const auto& t : hull.triangles) {
    const Vector3d& a = hull.vertices[t[0]];
    const Vector3d across = (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a);
    if (across.norm() < 1e-6 * size * size) {
      continue;  // a sliver says nothing about a plane
    }
    for (const auto& point : points) {
      RC_ASSERT(across.normalized().dot(point - a) <= 1e-9 * size);
    }
  }
}

RC_GTEST_PROP(ConvexHullLaws, surfaceIsClosed, ()) {
  const TriangleMesh hull = convexHullOf(anyPoints());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : hull.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++balance[{t[i], t[(i + 1) % 3]}];
      --balance[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const auto& [edge, count] : balance) {
    RC_ASSERT(count == 0);
  }
}

RC_GTEST_PROP(ConvexHullLaws, verticesAreDistinctPointsOfTheInput, ()) {
  const auto points = anyPoints();
  const TriangleMesh hull = convexHullOf(points);
  RC_ASSERT(!hull.vertices.empty());
  for (const auto& vertex : hull.vertices) {
    RC_ASSERT(std::count(points.begin(), points.end(), vertex) >= 1);
    RC_ASSERT(std::count(hull.vertices.begin(), hull.vertices.end(), vertex) == 1);
  }
}

}  // namespace
}  // namespace collision_monitor
