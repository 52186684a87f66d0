// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/triangle_bvh.h"

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/build_bvh.h"
#include "geometry/bvh/visit_near.h"
#include "geometry/meshes/check_mesh.h"
#include "geometry/point_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Triangle = TriangleBvh::Triangle;

// [m] A smaller mesh becomes a point of the unit frame: squares of its coordinates underflow.
constexpr double kLeastScale = 1e-150;

std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.empty() ? mesh.vertices.size() : mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  if (triangles.empty()) {
    for (const auto& vertex : mesh.vertices) {
      triangles.push_back({vertex, vertex, vertex});
    }
  }
  return triangles;
}

Aabb boundsOf(const std::vector<Triangle>& triangles) {
  Aabb box{triangles[0][0], triangles[0][0]};
  for (const auto& triangle : triangles) {
    for (const auto& corner : triangle) {
      box.min = box.min.cwiseMin(corner);
      box.max = box.max.cwiseMax(corner);
    }
  }
  return box;
}

}  // namespace

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  checkMesh(mesh);
  triangles_ = trianglesOf(mesh);
  bounds_ = boundsOf(triangles_);
  unit_frame_.center = 0.5 * bounds_.min + 0.5 * bounds_.max;
  const double scale = (0.5 * bounds_.max - 0.5 * bounds_.min).maxCoeff();
  unit_frame_.scale = scale > kLeastScale ? scale : 1.0;
  nodes_ = buildBvh(unit_frame_, triangles_);
}

NearestPoint TriangleBvh::nearestOn(std::uint32_t leaf_triangle,
                                    const Vector3d& point) const noexcept {
  const Triangle& triangle = triangles_[leaf_triangle];
  NearestPoint nearest;
  nearest.point = closestPointOnTriangle(point, triangle[0], triangle[1], triangle[2]);
  nearest.distance = (nearest.point - point).norm();
  nearest.leaf_triangle = leaf_triangle;
  return nearest;
}

NearestPoint TriangleBvh::nearestTo(const Vector3d& point, const NearestPoint& start,
                                    double tolerance) const noexcept {
  NearestPoint best = start;
  const double needed = 1.0 / (1.0 + tolerance);
  Vector3d delta = best.point - point;
  // A triangle beyond the plane through the closest point so far, perpendicular to the direction
  // from the query to that point, is no nearer.
  const auto isBeyond = [&](const Triangle& triangle) {
    const double reach = needed * delta.squaredNorm();
    return best.leaf_triangle != kNone && delta.dot(triangle[0] - point) >= reach &&
           delta.dot(triangle[1] - point) >= reach && delta.dot(triangle[2] - point) >= reach;
  };
  visitNear(*this, unitQuery(unit_frame_, point, point), needed * start.distance,
            [&](std::uint32_t triangle) {
              if (!isBeyond(triangles_[triangle])) {
                const NearestPoint found = nearestOn(triangle, point);
                if (found.distance < best.distance) {
                  best = found;
                  delta = best.point - point;
                }
              }
              return needed * best.distance;
            });
  return best;
}

}  // namespace collision_monitor
