// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/simplex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

using Points = std::array<Eigen::Vector3d, 4>;

[[gnu::always_inline]] inline void offer(const NearestOnSimplex& candidate,
                                         NearestOnSimplex& best) noexcept {
  if (candidate.squared < best.squared) {
    best = candidate;
  }
}

[[gnu::always_inline]] inline void offerVertex(const Points& points, int i,
                                               NearestOnSimplex& best) noexcept {
  const Eigen::Vector3d& p = points[static_cast<std::size_t>(i)];
  offer({p.squaredNorm(), p, p, {i, 0, 0}, {1.0, 0.0, 0.0}, 1}, best);
}

[[gnu::always_inline]] inline void offerEdge(const Points& points, int i, int j,
                                             NearestOnSimplex& best) noexcept {
  const Eigen::Vector3d& p = points[static_cast<std::size_t>(i)];
  const Eigen::Vector3d edge = points[static_cast<std::size_t>(j)] - p;
  const double length_squared = edge.squaredNorm();
  const double along = -p.dot(edge);
  if (along <= 0.0 || along >= length_squared) {
    return;
  }
  const double share = along / length_squared;
  const Eigen::Vector3d point = p + share * edge;
  const double squared = point.squaredNorm();
  // A part of a near point's normal along the edge is rounding and is removed. For a far point the
  // edge is the less accurate one.
  const Eigen::Vector3d outward =
      squared < length_squared ? Eigen::Vector3d(point - point.dot(edge) / length_squared * edge)
                               : point;
  offer({squared, point, outward, {i, j, 0}, {1.0 - share, share, 0.0}, 2}, best);
}

[[gnu::always_inline]] inline void offerTriangle(const Points& points,
                                                 const std::array<int, 3>& corners,
                                                 NearestOnSimplex& best) noexcept {
  const Eigen::Vector3d& p = points[static_cast<std::size_t>(corners[0])];
  const Eigen::Vector3d first = points[static_cast<std::size_t>(corners[1])] - p;
  const Eigen::Vector3d second = points[static_cast<std::size_t>(corners[2])] - p;
  const Eigen::Vector3d normal = first.cross(second);
  const double squared = normal.squaredNorm();
  const double of_second = -first.cross(p).dot(normal);
  const double of_first = -p.cross(second).dot(normal);
  if (of_first <= 0.0 || of_second <= 0.0 || of_first + of_second >= squared) {
    return;
  }
  const double u = of_first / squared;
  const double v = of_second / squared;
  const Eigen::Vector3d point = p + u * first + v * second;
  const double distance_squared = point.squaredNorm();
  const double longest = std::max(first.squaredNorm(), second.squaredNorm());
  const bool is_near = distance_squared * longest < squared;  // nearer than the triangle is high
  offer({distance_squared, point, is_near ? normal : point, corners, {1.0 - u - v, u, v}, 3}, best);
}

bool isFat(const Points& p) noexcept {
  const Eigen::Vector3d first = p[1] - p[0];
  const Eigen::Vector3d second = p[2] - p[0];
  const double longest = std::max(first.squaredNorm(), second.squaredNorm());
  return first.cross(second).squaredNorm() > kLeastSineSquared * longest * longest;
}

// True if the origin is strictly inside all four faces. A flat tetrahedron holds nothing.
bool holdsOrigin(const Points& p) noexcept {
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d& base = p[(k + 1) % 4];
    const Eigen::Vector3d normal = (p[(k + 2) % 4] - base).cross(p[(k + 3) % 4] - base);
    const double of_opposite = normal.dot(p[k] - base);
    const double of_origin = -normal.dot(base);
    if (of_opposite == 0.0 || of_origin * of_opposite <= 0.0) {
      return false;
    }
  }
  return true;
}

void keep(const NearestOnSimplex& nearest, Simplex& simplex) noexcept {
  for (int i = 0; i < nearest.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    // Corners ascend, so none is overwritten before it is read.
    simplex.vertices[k] = simplex.vertices[static_cast<std::size_t>(nearest.corners[k])];
    simplex.weights[k] = nearest.weights[k];
  }
  simplex.size = nearest.size;
  simplex.nearest = nearest.point;
  simplex.distance = std::sqrt(nearest.squared);
  const Eigen::Vector3d normal = normalOf(nearest);
  simplex.normal = normal.isZero(0.0) ? simplex.normal : normal;
}

Points pointsOf(const Simplex& simplex, int count) noexcept {
  Points points;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    points[i] = simplex.vertices[i].difference;
  }
  return points;
}

}  // namespace

bool nearestInsideSpan(const Points& points, int count, NearestOnSimplex& nearest) noexcept {
  nearest.squared = std::numeric_limits<double>::infinity();
  if (count == 2) {
    offerEdge(points, 0, 1, nearest);
  } else if (count == 3 && isFat(points)) {
    offerTriangle(points, {0, 1, 2}, nearest);
  }
  return nearest.squared < std::numeric_limits<double>::infinity();
}

NearestOnSimplex nearestOfAll(const Points& points, int count) noexcept {
  NearestOnSimplex best;
  for (int newest = 0; newest < count; ++newest) {
    offer(nearestWith(points, newest), best);
  }
  return best;
}

NearestOnSimplex nearestWith(const Points& points, int newest) noexcept {
  NearestOnSimplex best;
  offerVertex(points, newest, best);
  for (int i = 0; i < newest; ++i) {
    offerEdge(points, i, newest, best);
    for (int j = 0; j < i; ++j) {
      offerTriangle(points, {j, i, newest}, best);
    }
  }
  return best;
}

bool spanAll(int count, Simplex& simplex) noexcept {
  NearestOnSimplex nearest;
  const bool is_inside = nearestOfSimplex(pointsOf(simplex, count), count, nearest);
  if (is_inside) {
    keep(nearest, simplex);
  }
  return is_inside;
}

bool insert(const SupportVertex& vertex, Simplex& simplex) noexcept {
  const int newest = simplex.size;
  simplex.vertices[static_cast<std::size_t>(newest)] = vertex;
  const Points points = pointsOf(simplex, newest + 1);
  if (newest == 3 && holdsOrigin(points)) {
    simplex.size = 4;
    simplex.contains_origin = true;
    return true;
  }
  const NearestOnSimplex nearest = nearestWith(points, newest);
  if (!(nearest.squared < simplex.distance * simplex.distance)) {
    return false;
  }
  keep(nearest, simplex);
  return true;
}

Eigen::Vector3d Simplex::pointOnA() const noexcept {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    point += weights[i] * vertices[i].on_a;
  }
  return point;
}

Eigen::Vector3d Simplex::pointOnB() const noexcept {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    point += weights[i] * vertices[i].on_b;
  }
  return point;
}

}  // namespace collision_monitor
