// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/nearest_on_cylinder.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/hull.h"

namespace collision_monitor {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Projection {
  Vector3d away;       // from the closest point on the cylinder to the point
  Vector2d outward;    // unit, from the axis to the point; zero within the radius
  double lag_around;   // share of a shift around the axis that the closest point does not follow
  bool is_beside;      // the closest point does not follow a shift outward
  bool is_beyond_cap;  // it does not follow a shift along the axis
};

[[gnu::always_inline]] inline Projection project(const Vector3d& point,
                                                 const Vector3d& half_extents) noexcept {
  const double radius = half_extents.x();
  const double height = half_extents.z();
  const double off_axis = std::sqrt(point.x() * point.x() + point.y() * point.y());
  const bool is_beside = off_axis > radius;
  const double beyond = is_beside ? off_axis - radius : 0.0;
  const double per_off_axis = is_beside ? 1.0 / off_axis : 0.0;
  const Vector2d outward(per_off_axis * point.x(), per_off_axis * point.y());
  const double on_axis = std::max(-height, std::min(height, point.z()));
  return {{beyond * outward.x(), beyond * outward.y(), point.z() - on_axis},
          outward,
          beyond * per_off_axis,
          is_beside,
          std::abs(point.z()) > height};
}

ClosestOnCylinder closestAt(const Vector3d& point, const Projection& at) noexcept {
  return {point - at.away, at.away};
}

// Second derivative of half the squared distance along a straight line.
double curvatureAlong(const Vector3d& delta, const Projection& at) noexcept {
  const double outward = at.outward.x() * delta.x() + at.outward.y() * delta.y();
  const double around = delta.x() * at.outward.y() - delta.y() * at.outward.x();
  const double of_side = at.lag_around * around * around + (at.is_beside ? outward * outward : 0.0);
  return of_side + (at.is_beyond_cap ? delta.z() * delta.z() : 0.0);
}

Vector3d combined(double s, const Vector3d& v, double t, const Vector3d& w) noexcept {
  return s * v + t * w;
}

}  // namespace

ClosestOnCylinder closestOf(const Vector3d& point, const Vector3d& half_extents) noexcept {
  return closestAt(point, project(point, half_extents));
}

ClosestOnCylinder closestToEdge(const Vector3d& from, const Vector3d& edge,
                                const Vector3d& half_extents, double& share) noexcept {
  Vector3d point = from + share * edge;
  Projection at = project(point, half_extents);
  for (int step = 0; step < kMaxClosestSteps; ++step) {
    const double slope = along(at.away, edge);
    const double curvature = curvatureAlong(edge, at);
    const double next = std::max(0.0, std::min(1.0, share - slope / curvature));
    if (!(curvature > 0.0) || next == share) {
      break;
    }
    const bool is_last = std::abs(next - share) <= kLastClosestStep;
    share = next;
    point = from + share * edge;
    at = project(point, half_extents);
    if (is_last) {
      break;
    }
  }
  return closestAt(point, at);
}

ClosestOnCylinder closestToRim(const Rim& rim, const Vector3d& half_extents,
                               Vector2d& turn) noexcept {
  const Vector3d x = rim.across.col(0);
  const Vector3d y = rim.across.col(1);
  Vector3d outward = combined(turn.x(), x, turn.y(), y);
  Vector3d point = rim.center + outward;
  Projection at = project(point, half_extents);
  for (int step = 0; step < kMaxClosestSteps; ++step) {
    const Vector3d delta = combined(turn.x(), y, -turn.y(), x);
    const double slope = along(at.away, delta);
    const double curvature = curvatureAlong(delta, at) - along(at.away, outward);
    if (!(curvature > 0.0)) {
      break;  // nearer to a maximum than to a minimum
    }
    const double angle = std::max(-1.0, std::min(1.0, -slope / curvature));
    const Vector2d turned(turn.x() - angle * turn.y(), turn.y() + angle * turn.x());
    turn = 1.0 / std::sqrt(turned.x() * turned.x() + turned.y() * turned.y()) * turned;
    outward = combined(turn.x(), x, turn.y(), y);
    point = rim.center + outward;
    at = project(point, half_extents);
    if (std::abs(angle) <= kLastClosestStep) {
      break;
    }
  }
  return closestAt(point, at);
}

}  // namespace collision_monitor
