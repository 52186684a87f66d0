// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/core_distance.h"

#include <Eigen/Geometry>

namespace collision_monitor {

Eigen::Vector3d perpendicularTo(const Eigen::Vector3d& direction) noexcept {
  // The cross product with the least aligned axis is longer than sqrt(2/3).
  Eigen::Index least = 0;
  direction.cwiseAbs().minCoeff(&least);
  return direction.cross(Eigen::Vector3d::Unit(least)).normalized();
}

}  // namespace collision_monitor
