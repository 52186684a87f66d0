// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// To the bit. What is NaN is not the same.
inline bool isSame(const Pose& one, const Pose& other) noexcept {
  return one.rotation == other.rotation && one.translation == other.translation;
}

/// [m] No point of a ball goes farther from one pose to the other, straight or on any other way on
/// which center and rotation go no farther than that.
///
/// Two rotations by t from each other differ by 2 sin(t / 2) as operators and by sqrt(2) times as
/// much in Frobenius' norm. Error: some ulps of the coordinates.
inline double motionOfBall(const Eigen::Vector3d& center, double radius, const Pose& from,
                           const Pose& to) noexcept {
  const double turn = std::sqrt(0.5 * (to.rotation - from.rotation).squaredNorm());
  return (to * center - from * center).norm() + turn * radius;
}

}  // namespace collision_monitor
