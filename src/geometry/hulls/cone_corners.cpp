// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/cone_corners.h"

#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {

std::vector<Eigen::Vector3d> cornersAroundCone(double radius, double half_length) {
  constexpr int kCorners = 64;
  constexpr double kRounding = 1e-14;
  const double reach = radius / std::cos(kPi / kCorners) * (1.0 + kRounding);
  std::vector<Eigen::Vector3d> corners{{0.0, 0.0, half_length}};
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * kPi * i / kCorners;
    corners.emplace_back(reach * std::cos(angle), reach * std::sin(angle), -half_length);
  }
  return corners;
}

}  // namespace collision_monitor
