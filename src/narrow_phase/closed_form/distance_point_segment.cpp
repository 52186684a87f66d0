// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {

SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const Capsule& b,
                               const Pose& world_from_b) noexcept {
  const Segment segment{world_from_b.translation, world_from_b.rotation.col(2), b.half_length};
  const double parameter = closestParameter(segment, world_from_a.translation);
  SignedDistance cores;
  cores.point_on_a = world_from_a.translation;
  cores.point_on_b = segment.at(parameter);
  Eigen::Vector3d between = cores.point_on_b - cores.point_on_a;
  cores.distance = between.norm();
  if (cores.distance <= kNear) {
    between = -towardsNormalCone(segment, parameter, -between);
  }
  // If the point is on the segment, every direction across the segment realises the distance.
  const double length = between.norm();
  cores.normal_a_to_b =
      length > kTouching ? Eigen::Vector3d(between / length) : perpendicularTo(segment.direction);
  return inflated(cores, a.radius, b.radius);
}

}  // namespace collision_monitor
