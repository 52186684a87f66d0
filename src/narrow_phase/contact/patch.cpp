// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/patch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collision_monitor {
namespace {

// Four cuts leave at most eight corners of a parallelogram. The two spare ones take corners that
// rounding adds when a cut runs along an edge.
struct Polygon {
  std::array<Eigen::Vector2d, 10> corners;
  std::size_t size{0};

  void add(const Eigen::Vector2d& corner) noexcept {
    if (size < corners.size()) {
      corners[size++] = corner;
    }
  }
};

constexpr double kThin = 1e-14;  // area over squared length

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

// Keeps side * x[axis] <= limit. New corners lie exactly on the line, so that a face of no width
// keeps the points on it.
Polygon cut(const Polygon& polygon, Eigen::Index axis, double side, double limit) noexcept {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Eigen::Vector2d& from = polygon.corners[i];
    const Eigen::Vector2d& to = polygon.corners[(i + 1) % polygon.size];
    const double from_beyond = side * from[axis] - limit;
    const double to_beyond = side * to[axis] - limit;
    if (from_beyond <= 0.0) {
      kept.add(from);
    }
    if ((from_beyond <= 0.0) != (to_beyond <= 0.0)) {
      Eigen::Vector2d corner = from + from_beyond / (from_beyond - to_beyond) * (to - from);
      corner[axis] = side * limit;
      kept.add(corner);
    }
  }
  return kept;
}

Eigen::Vector2d middleOfBounds(const Eigen::Vector2d* corners, std::size_t count) noexcept {
  Eigen::Vector2d low = corners[0];
  Eigen::Vector2d high = corners[0];
  for (std::size_t i = 1; i < count; ++i) {
    low = low.cwiseMin(corners[i]);
    high = high.cwiseMax(corners[i]);
  }
  return 0.5 * (low + high);
}

bool clippedSegmentCenter(const FlatFeature& feature, const Eigen::Vector2d& limits,
                          Eigen::Vector2d& center) noexcept {
  double low = -1.0;
  double high = 1.0;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double slope = feature.sides[0][axis];
    const double start = feature.center[axis];
    if (std::abs(start) + std::abs(slope) <= limits[axis]) {
      continue;
    }
    if (slope == 0.0) {
      return false;
    }
    const double middle = -start / slope;
    const double reach = limits[axis] / std::abs(slope);
    low = std::max(low, middle - reach);
    high = std::min(high, middle + reach);
  }
  if (low > high) {
    return false;
  }
  center = feature.center + 0.5 * (low + high) * feature.sides[0];
  return true;
}

bool clippedPolygonCenter(const FlatFeature& feature, const Eigen::Vector2d& limits,
                          Eigen::Vector2d& center) noexcept {
  const Eigen::Vector2d& u = feature.sides[0];
  const Eigen::Vector2d v =
      cross(u, feature.sides[1]) < 0.0 ? Eigen::Vector2d(-feature.sides[1]) : feature.sides[1];
  Polygon polygon;  // counter-clockwise
  polygon.add(feature.center - u - v);
  polygon.add(feature.center + u - v);
  polygon.add(feature.center + u + v);
  polygon.add(feature.center - u + v);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    polygon = cut(polygon, axis, 1.0, limits[axis]);
    polygon = cut(polygon, axis, -1.0, limits[axis]);
  }
  if (polygon.size == 0) {
    return false;
  }
  center = centroidOf(polygon.corners.data(), polygon.size);
  return true;
}

bool clippedCenter(const FlatFeature& feature, const Eigen::Vector2d& limits,
                   Eigen::Vector2d& center) noexcept {
  switch (feature.side_count) {
    case 0:
      center = feature.center;
      return (feature.center.cwiseAbs().array() <= limits.array()).all();
    case 1:
      return clippedSegmentCenter(feature, limits, center);
    default:
      return clippedPolygonCenter(feature, limits, center);
  }
}

}  // namespace

// Sums the triangles of a fan about the first corner, weighted by area.
Eigen::Vector2d centroidOf(const Eigen::Vector2d* corners, std::size_t count) noexcept {
  const Eigen::Vector2d& apex = corners[0];
  Eigen::Vector2d weighed = Eigen::Vector2d::Zero();
  double area = 0.0;
  double length_squared = 0.0;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Eigen::Vector2d to = corners[i] - apex;
    const Eigen::Vector2d next = corners[i + 1] - apex;
    const double weight = std::abs(cross(to, next));
    weighed += weight / 3.0 * (to + next);
    area += weight;
    length_squared = std::max({length_squared, to.squaredNorm(), next.squaredNorm()});
  }
  return area > kThin * length_squared ? Eigen::Vector2d(apex + weighed / area)
                                       : middleOfBounds(corners, count);
}

bool patchCenter(const FlatFeature& feature, const Eigen::Vector2d& half_extents, double tolerance,
                 Eigen::Vector2d& center) noexcept {
  return clippedCenter(feature, half_extents, center) ||
         clippedCenter(feature, half_extents + Eigen::Vector2d::Constant(tolerance), center);
}

}  // namespace collision_monitor
