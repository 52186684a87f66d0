// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>

#include "collision_monitor/narrow_phase/distance.h"
#include "narrow_phase/closest_points.h"
#include "narrow_phase/core_distance.h"

namespace collision_monitor {
namespace {

// Perpendicular to both segments; for parallel ones, to the first.
Eigen::Vector3d commonPerpendicular(const Segment& a, const Segment& b) noexcept {
  const Eigen::Vector3d normal = a.direction.cross(b.direction);
  const double sine = normal.norm();
  return sine > kParallel ? Eigen::Vector3d(normal / sine) : perpendicularTo(a.direction);
}

// The normal is perpendicular to each segment that is met between its ends. Where the points
// nearly coincide this is known better than their difference.
Eigen::Vector3d normalOfNear(const Segment& a, const Segment& b, const ClosestParameters& closest,
                             Eigen::Vector3d between) noexcept {
  const bool within_a = std::abs(closest.on_a) < a.half_length;
  const bool within_b = std::abs(closest.on_b) < b.half_length;
  if (within_a && within_b) {
    const Eigen::Vector3d normal = commonPerpendicular(a, b);
    const double along = normal.dot(between);
    if (std::abs(along) >= between.norm() - kTouching) {
      return signOf(along) * normal;
    }
  } else if (within_a) {
    between -= between.dot(a.direction) * a.direction;
  } else if (within_b) {
    between -= between.dot(b.direction) * b.direction;
  }
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
  return swept(cores, a.radius, b.radius);
}

}  // namespace collision_monitor
