// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/point_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Height over longest edge, squared: below it the normal is mostly rounding, and the edges are
// nearer to every point of the triangle than that.
constexpr double kSliver = 1e-20;

/// The foot of the perpendicular from `point`, where it lies inside the triangle.
/// As a weighted mean of the corners, so that it is on the triangle whatever the normal's error.
bool footInside(const Vector3d& point, const Vector3d (&corners)[3], Vector3d& foot) {
  const Vector3d ab = corners[1] - corners[0];
  const Vector3d ac = corners[2] - corners[0];
  const Vector3d normal = ab.cross(ac);
  const double longest_squared = std::max(ab.squaredNorm(), ac.squaredNorm());
  if (!(normal.squaredNorm() > kSliver * longest_squared * longest_squared)) {
    return false;
  }
  double weights[3];
  for (int i = 0; i < 3; ++i) {
    const Vector3d& from = corners[(i + 1) % 3];
    const Vector3d& to = corners[(i + 2) % 3];
    weights[i] = normal.dot((to - from).cross(point - from));
    if (weights[i] < 0.0) {
      return false;
    }
  }
  const double sum = weights[0] + weights[1] + weights[2];
  foot = corners[0] + weights[1] / sum * ab + weights[2] / sum * ac;
  return true;
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
  // From the nearer end, so that t = 1 gives b and not b with the rounding of a + (b - a).
  return t <= 0.5 ? Vector3d(a + t * along) : Vector3d(b - (1.0 - t) * along);
}

Vector3d closestPointOnTriangle(const Vector3d& point, const Vector3d& a, const Vector3d& b,
                                const Vector3d& c) noexcept {
  Vector3d foot;
  if (footInside(point, {a, b, c}, foot)) {
    return foot;
  }
  const Vector3d candidates[3] = {closestPointOnSegment(point, a, b),
                                  closestPointOnSegment(point, b, c),
                                  closestPointOnSegment(point, c, a)};
  return *std::min_element(candidates, candidates + 3, [&](const auto& p, const auto& q) {
    return (p - point).squaredNorm() < (q - point).squaredNorm();
  });
}

}  // namespace collision_monitor
