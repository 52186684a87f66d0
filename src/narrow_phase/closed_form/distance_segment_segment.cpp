// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {
namespace {

// Between kParallel and this sine a cross product of the directions is too noisy.
constexpr double kNearlyParallel = 1e-4;

// Perpendicular to both segments, or to `a` if they are parallel. b's direction is made orthogonal
// to a's before the cross product, so that the result is accurate at every angle.
Eigen::Vector3d commonPerpendicular(const Segment& a, const Segment& b) noexcept {
  const Eigen::Vector3d across = b.direction - a.direction.dot(b.direction) * a.direction;
  return across.squaredNorm() > kParallel * kParallel
             ? Eigen::Vector3d(a.direction.cross(across).normalized())
             : perpendicularTo(a.direction);
}

// The normal is perpendicular to a segment whose closest point is between its ends; at an end it
// leads beyond the end. For near points this is more accurate than their difference.
Eigen::Vector3d normalOfNear(const Segment& a, const Segment& b, const ClosestParameters& closest,
                             Eigen::Vector3d between) noexcept {
  const bool within_a = std::abs(closest.on_a) < a.half_length;
  const bool within_b = std::abs(closest.on_b) < b.half_length;
  const double sine = a.direction.cross(b.direction).norm();
  if (within_a && within_b && sine > kNearlyParallel) {
    const Eigen::Vector3d normal = commonPerpendicular(a, b);
    return signOf(normal.dot(between)) * normal;
  }
  between = towardsNormalCone(a, closest.on_a, between);
  between = -towardsNormalCone(b, closest.on_b, -between);
  const double length = between.norm();
  return length > kTouching ? Eigen::Vector3d(between / length) : commonPerpendicular(a, b);
}

}  // namespace

SignedDistance distanceBetween(const Capsule& a, const Pose& world_from_a, const Capsule& b,
                               const Pose& world_from_b) noexcept {
  const Segment on_a{world_from_a.translation, world_from_a.rotation.col(2), a.half_length};
  const Segment on_b{world_from_b.translation, world_from_b.rotation.col(2), b.half_length};
  const ClosestParameters closest = closestParameters(on_a, on_b);

  SignedDistance cores;
  cores.point_on_a = on_a.at(closest.on_a);
  cores.point_on_b = on_b.at(closest.on_b);
  const Eigen::Vector3d between = cores.point_on_b - cores.point_on_a;
  cores.distance = between.norm();
  cores.normal_a_to_b = cores.distance > kNear ? Eigen::Vector3d(between / cores.distance)
                                               : normalOfNear(on_a, on_b, closest, between);
  return inflated(cores, a.radius, b.radius);
}

}  // namespace collision_monitor
