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

/// How far a point at unit distance from the center is turned at most: 2 sin(t / 2), if the
/// rotations are t apart. Their difference has sqrt(2) times that as its Frobenius norm.
/// Error: some ulps.
inline double turnBetween(const Pose& from, const Pose& to) noexcept {
  return std::sqrt(0.5 * (to.rotation - from.rotation).squaredNorm());
}

/// [m] An upper bound of how far any point of a ball moves from one pose to the other: straight, or
/// on any path on which center and rotation travel no farther.
///
/// Error: some ulps of the coordinates.
inline double motionOfBall(const Eigen::Vector3d& center, double radius, const Pose& from,
                           const Pose& to) noexcept {
  return (to * center - from * center).norm() + turnBetween(from, to) * radius;
}

}  // namespace collision_monitor
