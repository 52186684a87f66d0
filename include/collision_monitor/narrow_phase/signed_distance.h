// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The answer of every pair routine.
///
/// Frames: points and normal are in the world frame.
/// Sign: distance > 0 apart, 0 touching, < 0 minus the penetration depth (the length of the least
/// translation that separates the shapes).
/// `normal_a_to_b` is a unit vector from A to B.
/// `point_on_b - point_on_a = distance * normal_a_to_b` also holds for shapes that overlap.
struct SignedDistance {
  double distance{0.0};                                     ///< [m]
  Eigen::Vector3d point_on_a{Eigen::Vector3d::Zero()};      ///< [m] A's witness point
  Eigen::Vector3d point_on_b{Eigen::Vector3d::Zero()};      ///< [m] B's witness point
  Eigen::Vector3d normal_a_to_b{Eigen::Vector3d::UnitX()};  ///< unit
};

}  // namespace collision_monitor
