// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle_core.h"

#include <array>

#include "narrow_phase/closest_points.h"
#include "narrow_phase/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A point is a segment of no length.
PointPair nearestToSegment(const Triangle& triangle, const Vector3d& half_extents,
                           const PointPair& start) noexcept {
  const PreparedTriangle prepared = prepare(triangle);
  const Vector3d& end = half_extents;
  PointPair best = start;
  improveByPiercing(prepared, -end, end, best);
  const Edge core = makeEdge(-end, end);
  for (const Edge& edge : prepared.edges) {
    improveByEdges(edge, core, best);
  }
  improveByFace(prepared, -end, best);
  improveByFace(prepared, end, best);
  return best;
}

// A triangle cut by six planes has nine corners at most; spare ones take those that rounding makes
// where a cut runs along an edge.
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

// The middle of the corners of what the box holds of the triangle.
bool sharedPoint(const Triangle& triangle, const Vector3d& half_extents,
                 Vector3d& shared) noexcept {
  Polygon polygon;
  for (const Vector3d& corner : triangle) {
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

// The four edges of the box along an axis, and their ends.
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

PointPair nearestToBox(const Triangle& triangle, const Vector3d& half_extents,
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

}  // namespace

PointPair nearestPoints(const Triangle& triangle, CoreKind kind, const Vector3d& half_extents,
                        const PointPair& start) noexcept {
  switch (kind) {
    case CoreKind::point:
    case CoreKind::segment:
      return nearestToSegment(triangle, half_extents, start);
    case CoreKind::box:
      return nearestToBox(triangle, half_extents, start);
  }
  return start;
}

}  // namespace collision_monitor
