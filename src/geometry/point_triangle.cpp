// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/point_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/based_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Squared ratio of height to longest edge. The normal of thinner triangles loses digits.
constexpr double kThin = 1e-6;

/// The projection of a point on the plane of a triangle.
struct ClosestPoint {
  Vector3d point;
  bool is_thin{false};  ///< if so, nothing else is known
  bool is_inside{false};
  bool is_beyond[3] = {true, true, true};  ///< edge i, which is opposite to corner i
};

/// The projection, as a weighted mean of the corners: so it lies on the triangle whatever the error
/// of the normal. If it is not inside, the closest point is on an edge that it lies beyond.
ClosestPoint closestOf(const Vector3d& point, const Vector3d (&corners)[3]) {
  ClosestPoint closest;
  const Vector3d ab = corners[1] - corners[0];
  const Vector3d ac = corners[2] - corners[0];
  const Vector3d normal = ab.cross(ac);
  const double longest_squared = std::max(ab.squaredNorm(), ac.squaredNorm());
  closest.is_thin = !(normal.squaredNorm() > kThin * longest_squared * longest_squared);
  if (closest.is_thin) {
    return closest;
  }
  double weights[3];
  for (int i = 0; i < 3; ++i) {
    const Vector3d& from = corners[(i + 1) % 3];
    const Vector3d& to = corners[(i + 2) % 3];
    weights[i] = normal.dot((to - from).cross(point - from));
    closest.is_beyond[i] = weights[i] < 0.0;
  }
  closest.is_inside = !closest.is_beyond[0] && !closest.is_beyond[1] && !closest.is_beyond[2];
  const double sum = weights[0] + weights[1] + weights[2];
  closest.point = corners[0] + weights[1] / sum * ab + weights[2] / sum * ac;
  return closest;
}

}  // namespace

Vector3d closestPointOnSegment(const Vector3d& point, const Vector3d& a,
                               const Vector3d& b) noexcept {
  const Vector3d along = b - a;
  const double length_squared = along.squaredNorm();
  if (!(length_squared > 0.0)) {
    return a;
  }
  const double t = std::clamp((point - a).dot(along) / length_squared, 0.0, 1.0);
  // Starts at the nearer end, so that t = 1 gives b exactly, without the rounding of a + (b - a).
  return t <= 0.5 ? Vector3d(a + t * along) : Vector3d(b - (1.0 - t) * along);
}

Vector3d closestPointOnTriangle(const Vector3d& point, const Vector3d& a, const Vector3d& b,
                                const Vector3d& c) noexcept {
  const Vector3d corners[3] = {a, b, c};
  const ClosestPoint closest = closestOf(point, corners);
  if (closest.is_inside) {
    return closest.point;
  }
  Vector3d nearest = closest.is_thin ? closestOn(baseOf({a, b, c}), point) : a;
  double least_squared =
      closest.is_thin ? (nearest - point).squaredNorm() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (closest.is_beyond[i]) {
      const Vector3d candidate =
          closestPointOnSegment(point, corners[(i + 1) % 3], corners[(i + 2) % 3]);
      const double squared = (candidate - point).squaredNorm();
      if (squared < least_squared) {
        least_squared = squared;
        nearest = candidate;
      }
    }
  }
  return nearest;
}

}  // namespace collision_monitor
