// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {

SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const Sphere& b,
                               const Pose& world_from_b) noexcept {
  SignedDistance cores;
  cores.point_on_a = world_from_a.translation;
  cores.point_on_b = world_from_b.translation;
  const Eigen::Vector3d between = cores.point_on_b - cores.point_on_a;
  cores.distance = between.norm();
  // For concentric spheres every direction is equally good.
  cores.normal_a_to_b = Eigen::Vector3d::UnitX();
  if (cores.distance > kTouching) {
    cores.normal_a_to_b = between / cores.distance;
  }
  return inflated(cores, a.radius, b.radius);
}

}  // namespace collision_monitor
