// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle/triangle_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A triangle cut by six planes has at most nine corners. The spare ones take corners that rounding
// adds when a cut runs along an edge.
struct Polygon {
  std::array<Vector3d, 12> corners;
  std::size_t size{0};

  void add(const Vector3d& corner) noexcept {
    if (size < corners.size()) {
      corners[size++] = corner;
    }
  }
};

// Keeps side * x[axis] <= limit.
Polygon cut(const Polygon& polygon, Eigen::Index axis, double side, double limit) noexcept {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vector3d& from = polygon.corners[i];
    const Vector3d& to = polygon.corners[(i + 1) % polygon.size];
    const double from_beyond = side * from[axis] - limit;
    const double to_beyond = side * to[axis] - limit;
    if (from_beyond <= 0.0) {
      kept.add(from);
    }
    if ((from_beyond <= 0.0) != (to_beyond <= 0.0)) {
      Vector3d corner = from + from_beyond / (from_beyond - to_beyond) * (to - from);
      corner[axis] = side * limit;
      kept.add(corner);
    }
  }
  return kept;
}

// A corner of the triangle inside the box, or the mean of the corners of the part inside.
bool sharedPoint(const Triangle& triangle, const Vector3d& half_extents,
                 Vector3d& shared) noexcept {
  Polygon polygon;
  for (const Vector3d& corner : triangle) {
    if ((corner.cwiseAbs().array() <= half_extents.array()).all()) {
      shared = corner;
      return true;
    }
    polygon.add(corner);
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    polygon = cut(polygon, axis, 1.0, half_extents[axis]);
    polygon = cut(polygon, axis, -1.0, half_extents[axis]);
  }
  shared.setZero();
  for (std::size_t i = 0; i < polygon.size; ++i) {
    shared += polygon.corners[i] / static_cast<double>(polygon.size);
  }
  return polygon.size > 0;
}

// Tries the four edges of the box along an axis, and their ends.
void improveByBoxEdges(const PreparedTriangle& triangle, const Vector3d& half_extents,
                       Eigen::Index axis, PointPair& best) noexcept {
  for (const double p : {-1.0, 1.0}) {
    for (const double q : {-1.0, 1.0}) {
      Vector3d end = half_extents;
      end[(axis + 1) % 3] *= p;
      end[(axis + 2) % 3] *= q;
      Vector3d start = end;
      start[axis] = -end[axis];
      const Edge edge_of_box = makeEdge(start, end);
      for (const Edge& edge : triangle.edges) {
        improveByEdges(edge, edge_of_box, best);
      }
      if (axis == 0) {
        improveByFace(triangle, start, best);
        improveByFace(triangle, end, best);
      }
    }
  }
}

}  // namespace

PointPair nearestToBox(const Triangle& triangle, const Eigen::Vector3d& half_extents,
                       const PointPair& start) noexcept {
  PointPair best = start;
  Vector3d shared;
  if (sharedPoint(triangle, half_extents, shared)) {
    return {0.0, shared, shared};
  }
  for (const Vector3d& corner : triangle) {
    const Vector3d in_box = closestInBox(half_extents, corner);
    const double squared_distance = (corner - in_box).squaredNorm();
    if (squared_distance < best.squared_distance) {
      best = {squared_distance, corner, in_box};
    }
  }
  const PreparedTriangle prepared = prepare(triangle);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    improveByBoxEdges(prepared, half_extents, axis, best);
  }
  return best;
}

Vector3d acrossEdges(const Triangle& triangle, const Vector3d& half_extents,
                     double squared_cutoff) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d edge = triangle[(k + 1) % 3] - triangle[k];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vector3d across = Vector3d::Unit(axis).cross(edge);
      const double on_edge = across.dot(triangle[k]);
      const double opposite = across.dot(triangle[(k + 2) % 3]);
      const double middle = 0.5 * (on_edge + opposite);
      const double gap = std::abs(middle) - 0.5 * std::abs(on_edge - opposite) -
                         half_extents.dot(across.cwiseAbs());
      if (gap > 0.0 && gap * gap >= squared_cutoff * across.squaredNorm()) {
        return middle < 0.0 ? across : Vector3d(-across);
      }
    }
  }
  return Vector3d::Zero();
}

}  // namespace collision_monitor
