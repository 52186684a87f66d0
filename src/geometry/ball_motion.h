// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// Whether the poses are equal to the bit. NaN equals nothing.
inline bool isSame(const Pose& one, const Pose& other) noexcept {
  return one.rotation == other.rotation && one.translation == other.translation;
}

/// [m] An upper bound of how far any point of a ball moves from one pose to the other: straight, or
/// on any path on which center and rotation travel no farther.
///
/// As operators, two rotations by t from each other differ by 2 sin(t / 2); their Frobenius norm
/// differs by sqrt(2) times that. Error: some ulps of the coordinates.
inline double motionOfBall(const Eigen::Vector3d& center, double radius, const Pose& from,
                           const Pose& to) noexcept {
  const double turn = std::sqrt(0.5 * (to.rotation - from.rotation).squaredNorm());
  return (to * center - from * center).norm() + turn * radius;
}

}  // namespace collision_monitor
