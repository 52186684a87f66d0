// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/nearest_on_cylinder.h"

#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr int kMaxSteps = 12;
// The step after this one would be its square.
constexpr double kLastStep = 1e-8;

struct Projection {
  CylinderFoot foot;
  Eigen::Vector2d outward;  // unit, from the axis to the point
  // What of a shift of the point the foot does not follow: around, outward and along the axis.
  double lag_around, lag_outward, lag_along;
};

Projection project(const Vector3d& point, const Vector3d& half_extents) noexcept {
  const double radius = half_extents.x();
  const double height = half_extents.z();
  const double off_axis = std::sqrt(point.x() * point.x() + point.y() * point.y());
  const bool is_beside = off_axis > radius;
  const double scale = is_beside ? radius / off_axis : 1.0;
  Projection found;
  found.foot.on_cylinder = {scale * point.x(), scale * point.y(),
                            std::max(-height, std::min(height, point.z()))};
  found.foot.away = point - found.foot.on_cylinder;
  found.outward = is_beside ? Eigen::Vector2d(point.head<2>() / off_axis)
                            : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  found.lag_around = 1.0 - scale;
  found.lag_outward = is_beside ? 1.0 : 0.0;
  found.lag_along = std::abs(point.z()) > height ? 1.0 : 0.0;
  return found;
}

// Second derivative of half the squared distance on a straight way.
double curvatureAlong(const Vector3d& way, const Projection& at) noexcept {
  const double outward = at.outward.dot(way.head<2>());
  const double around = way.x() * at.outward.y() - way.y() * at.outward.x();
  return at.lag_around * around * around + at.lag_outward * outward * outward +
         at.lag_along * way.z() * way.z();
}

}  // namespace

CylinderFoot footOf(const Vector3d& point, const Vector3d& half_extents) noexcept {
  return project(point, half_extents).foot;
}

CylinderFoot footOfEdge(const Vector3d& from, const Vector3d& edge, const Vector3d& half_extents,
                        double& share) noexcept {
  Projection at = project(from + share * edge, half_extents);
  for (int step = 0; step < kMaxSteps; ++step) {
    const double slope = at.foot.away.dot(edge);
    const double curvature = curvatureAlong(edge, at);
    const double next = std::max(0.0, std::min(1.0, share - slope / curvature));
    if (!(curvature > 0.0) || next == share) {
      break;
    }
    const bool is_last = std::abs(next - share) <= kLastStep;
    share = next;
    at = project(from + share * edge, half_extents);
    if (is_last) {
      break;
    }
  }
  return at.foot;
}

CylinderFoot footOfRim(const Rim& rim, const Vector3d& half_extents,
                       Eigen::Vector2d& turn) noexcept {
  Projection at = project(rim.center + rim.across * turn, half_extents);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vector3d way = rim.across * Eigen::Vector2d(-turn.y(), turn.x());
    const double slope = at.foot.away.dot(way);
    const double curvature = curvatureAlong(way, at) - at.foot.away.dot(rim.across * turn);
    if (!(curvature > 0.0)) {
      break;  // farther from the least than from the most
    }
    const double angle = std::max(-1.0, std::min(1.0, -slope / curvature));
    turn = (turn + angle * Eigen::Vector2d(-turn.y(), turn.x())).normalized();
    at = project(rim.center + rim.across * turn, half_extents);
    if (std::abs(angle) <= kLastStep) {
      break;
    }
  }
  return at.foot;
}

}  // namespace collision_monitor
