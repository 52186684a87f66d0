// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The smallest rotation that turns z onto the unit vector `axis`. It defines the x and y axes of a
/// planar joint's plane.
Eigen::Matrix3d rotationFromZTo(const Eigen::Vector3d& axis) noexcept;

}  // namespace collision_monitor
