// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/manifold_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kSamePoint = 1e-9;

// Index of the largest `value`. Values within `kSamePoint` are equal, and the first one wins, so
// that rounding does not choose. Returns points.size if none is above `kSamePoint`.
template <class Value>
std::size_t largest(const ManifoldPoints& points, const Value& value) noexcept {
  std::size_t best = points.size;
  double best_value = kSamePoint;
  for (std::size_t i = 0; i < points.size; ++i) {
    const double here = value(points.points[i]);
    if (here > best_value) {
      best = i;
      best_value = here + kSamePoint;
    }
  }
  return best;
}

void keep(const ManifoldPoints& points, std::size_t index, ContactManifold& manifold) noexcept {
  if (index < points.size) {
    manifold.points[manifold.size++] = points.points[index];
  }
}

void setCenter(ContactManifold& manifold) noexcept {
  const double share = 1.0 / static_cast<double>(manifold.size);
  manifold.center = ManifoldPoint{};
  for (std::size_t i = 0; i < manifold.size; ++i) {
    manifold.center.point_on_a += share * manifold.points[i].point_on_a;
    manifold.center.point_on_b += share * manifold.points[i].point_on_b;
    manifold.center.distance += share * manifold.points[i].distance;
  }
}

}  // namespace

ContactPatch extremePatch(const Shape& shape, const Pose& world_from_shape,
                          const Vector3d& direction, double flat_sine) noexcept {
  const Vector3d half_extents = coreHalfExtents(shape);
  Vector3d center = world_from_shape.translation + radiusOf(shape) * direction;
  std::array<Vector3d, 2> sides;
  std::size_t side_count = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3d side = half_extents[k] * world_from_shape.rotation.col(k);
    const double slope = direction.dot(world_from_shape.rotation.col(k));
    if (std::abs(slope) > flat_sine || side_count == sides.size()) {
      center += signOf(slope) * side;
    } else if (half_extents[k] > 0.0) {
      sides[side_count++] = side;
    }
  }
  ContactPatch patch;
  if (side_count == 0) {
    patch.corners[patch.size++] = center;
  } else if (side_count == 1) {
    patch.corners[patch.size++] = center - sides[0];
    patch.corners[patch.size++] = center + sides[0];
  } else {
    patch.corners[patch.size++] = center - sides[0] - sides[1];
    patch.corners[patch.size++] = center + sides[0] - sides[1];
    patch.corners[patch.size++] = center + sides[0] + sides[1];
    patch.corners[patch.size++] = center - sides[0] + sides[1];
  }
  return patch;
}

void cut(const Vector3d& outward, const Vector3d& through, ClippedPolygon& polygon) noexcept {
  ClippedPolygon kept;
  // Two corners have one edge between them; a face has as many edges as corners.
  const std::size_t directions = polygon.size == 2 ? 1 : polygon.size;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vector3d& from = polygon.corners[i];
    const double from_beyond = outward.dot(from - through);
    if (from_beyond <= 0.0) {
      kept.add(from);
    }
    if (i >= directions) {
      continue;
    }
    const Vector3d& to = polygon.corners[(i + 1) % polygon.size];
    const double to_beyond = outward.dot(to - through);
    if ((from_beyond <= 0.0) != (to_beyond <= 0.0)) {
      kept.add(from + from_beyond / (from_beyond - to_beyond) * (to - from));
    }
  }
  polygon = kept;
}

void dropFarther(double limit, ManifoldPoints& points) noexcept {
  const auto end = std::remove_if(points.points.begin(), points.points.begin() + points.size,
                                  [limit](const ManifoldPoint& p) { return p.distance > limit; });
  points.size = static_cast<std::size_t>(end - points.points.begin());
}

void spreadOut(const ManifoldPoints& points, ContactManifold& manifold) noexcept {
  manifold.size = 0;
  double nearest = points.points[0].distance;
  for (std::size_t i = 1; i < points.size; ++i) {
    nearest = std::min(nearest, points.points[i].distance);
  }
  keep(points,
       largest(points,
               [&](const ManifoldPoint& p) { return nearest - p.distance + 2.0 * kSamePoint; }),
       manifold);
  const Vector3d first = manifold.points[0].point_on_a;
  keep(points,
       largest(points, [&](const ManifoldPoint& p) { return (p.point_on_a - first).norm(); }),
       manifold);
  if (manifold.size == 2) {
    const Vector3d across =
        (manifold.points[1].point_on_a - first).cross(manifold.normal_a_to_b).normalized();
    for (const double side : {1.0, -1.0}) {
      keep(points,
           largest(points,
                   [&](const ManifoldPoint& p) { return side * across.dot(p.point_on_a - first); }),
           manifold);
    }
  }
  setCenter(manifold);
}

}  // namespace collision_monitor
