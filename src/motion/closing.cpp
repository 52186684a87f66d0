// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/motion/closing.h"

#include <cmath>
#include <limits>

namespace collision_monitor {

double distanceRate(const SignedDistance& measured, const Twist& twist_a,
                    const Twist& twist_b) noexcept {
  // Seen from A, where both points move alike along the normal.
  const Eigen::Vector3d velocity = velocityAt(twist_b - twist_a, measured.point_on_b);
  const Eigen::Vector3d& normal = measured.normal_a_to_b;
  return normal.x() * velocity.x() + normal.y() * velocity.y() + normal.z() * velocity.z();
}

double timeToContact(double gap, double closing_speed, double horizon) noexcept {
  if (std::isnan(gap) || gap <= 0.0) {
    return std::isnan(gap) ? gap : 0.0;
  }
  if (std::isnan(closing_speed)) {
    return closing_speed;
  }
  return gap <= closing_speed * horizon ? gap / closing_speed
                                        : std::numeric_limits<double>::infinity();
}

}  // namespace collision_monitor
