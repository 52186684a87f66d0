// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/closing_bound.h"

#include <algorithm>
#include <cmath>

namespace collision_monitor {

double closingBound(const Ball& a, const Ball& b, const Twist& b_from_a) noexcept {
  const Ball& smaller = a.radius < b.radius ? a : b;
  const Eigen::Vector3d velocity = velocityAt(b_from_a, smaller.center);
  const Eigen::Vector3d between = b.center - a.center;
  const double squared_distance = between.squaredNorm();
  const double radii = a.radius + b.radius;
  const double along = -between.dot(velocity);
  const double squared_speed = velocity.squaredNorm();
  const double squared_tangent = squared_distance - radii * radii;
  // The fastest direction is against the velocity, if that is within the angle, or at its edge.
  const bool holds_velocity =
      !(squared_tangent > 0.0) || (along > 0.0 && along * along >= squared_tangent * squared_speed);
  const double across = std::sqrt(std::max(0.0, squared_distance * squared_speed - along * along));
  const double of_center =
      holds_velocity ? std::sqrt(squared_speed)
                     : (along * std::sqrt(squared_tangent) + across * radii) / squared_distance;
  return of_center + smaller.radius * b_from_a.angular.norm();
}

}  // namespace collision_monitor
