// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace collision_monitor {

/// How body B moves, seen from body A, in an interval: from the middle to the time s, which runs
/// from -1 to 1, a point x of B moves by s * velocityAt(x), up to `deviation`. Seen from B, the
/// points of A move by the opposite, up to `deviation_of_a`.
///
/// Frames: any, as it stands in the middle. Units: metres and radians per half interval.
struct RelativeMotion {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  Eigen::Vector3d velocity{Eigen::Vector3d::Zero()};  ///< of the point at `center`
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};
  double deviation{0.0};       ///< [m] for all points of B
  double deviation_of_a{0.0};  ///< [m] for all points of A

  Eigen::Vector3d velocityAt(const Eigen::Vector3d& point) const noexcept {
    return velocity + turn.cross(point - center);
  }
};

}  // namespace collision_monitor
