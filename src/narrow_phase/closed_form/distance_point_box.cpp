// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {
namespace {

// Frames: that of the box, which is B.
SignedDistance pointToBox(const Eigen::Vector3d& point,
                          const Eigen::Vector3d& half_extents) noexcept {
  SignedDistance cores;
  cores.point_on_a = point;
  cores.point_on_b = closestInBox(half_extents, point);
  const Eigen::Vector3d outward = point - cores.point_on_b;
  const double outside = outward.norm();
  if (outside > kTouching) {
    cores.distance = outside;
    cores.normal_a_to_b = outward / -outside;
    return cores;
  }
  // The point is inside: the nearest face gives the depth.
  Eigen::Index axis = 0;
  cores.distance = (point.cwiseAbs() - half_extents).maxCoeff(&axis);
  const double side = signOf(point[axis]);
  cores.point_on_b[axis] = side * half_extents[axis];
  cores.normal_a_to_b = -side * Eigen::Vector3d::Unit(axis);
  return cores;
}

}  // namespace

SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept {
  const Eigen::Vector3d between = world_from_a.translation - world_from_b.translation;
  const SignedDistance cores =
      pointToBox(world_from_b.rotation.transpose() * between, b.half_extents);
  return inflated(placed(world_from_b, cores), a.radius, b.radius);
}

}  // namespace collision_monitor
