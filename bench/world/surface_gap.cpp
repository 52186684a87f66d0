// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface_gap.h"

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

#include "support/reference/convex_reference.h"

namespace collision_monitor::test {
namespace {

/// A convex part of a geometry, and a ball around it in the frame of the geometry.
struct Part {
  ConvexGeometry geometry;
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

struct ToParts {
  std::vector<Part> operator()(const TriangleMesh& mesh) const {
    std::vector<Part> parts;
    for (const auto& corners : mesh.triangles) {
      const std::vector<Eigen::Vector3d> points{
          mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
      const Eigen::Vector3d center = (points[0] + points[1] + points[2]) / 3.0;
      double radius = 0.0;
      for (const Eigen::Vector3d& point : points) {
        radius = std::max(radius, (point - center).norm());
      }
      parts.push_back({ConvexHull(points), center, radius});
    }
    return parts;
  }
  template <class Primitive>
  std::vector<Part> operator()(const Primitive& primitive) const {
    return {{primitive, Eigen::Vector3d::Zero(), extentOf(primitive)}};
  }
};

}  // namespace

double surfaceGap(const Geometry& a, const Pose& world_from_a, const Geometry& b,
                  const Pose& world_from_b) {
  const std::vector<Part> parts_of_a = std::visit(ToParts(), a);
  const std::vector<Part> parts_of_b = std::visit(ToParts(), b);
  double least = std::numeric_limits<double>::infinity();
  for (const Part& of_a : parts_of_a) {
    for (const Part& of_b : parts_of_b) {
      const double between = (world_from_a * of_a.center - world_from_b * of_b.center).norm();
      long double distance = 0.0;
      if (between - of_a.radius - of_b.radius < least &&
          convexReference({&of_a.geometry, world_from_a, &of_b.geometry, world_from_b}, distance)) {
        least = std::min(least, static_cast<double>(distance));
      }
    }
  }
  return least;
}

}  // namespace collision_monitor::test
