// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rpy.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {

Eigen::Matrix3d rotationOfRpy(const Eigen::Vector3d& rpy) noexcept {
  return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d rpyOf(const Eigen::Matrix3d& rotation) noexcept {
  constexpr double kUpright = 1e-9;
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  const double pitch = std::atan2(-rotation(2, 0), level);
  if (level < kUpright) {
    return {0.0, pitch, std::atan2(-rotation(0, 1), rotation(1, 1))};
  }
  return {std::atan2(rotation(2, 1), rotation(2, 2)), pitch,
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

}  // namespace collision_monitor
