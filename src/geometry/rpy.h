// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The rotation of roll, pitch and yaw about fixed axes, R = Rz(yaw) Ry(pitch) Rx(roll), as in a
/// URDF. Units: radians.
Eigen::Matrix3d rotationOfRpy(const Eigen::Vector3d& rpy) noexcept;

/// Roll, pitch and yaw of a rotation. Roll is 0 where the pitch leaves it undetermined. Units:
/// radians. Error: they reproduce the rotation to about 1e-16 over the cosine of the pitch, never
/// worse than 1e-6.
Eigen::Vector3d rpyOf(const Eigen::Matrix3d& rotation) noexcept;

}  // namespace collision_monitor
