// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The least rotation that turns z onto the unit vector `axis`: it gives the plane of a planar
/// joint its x and y.
Eigen::Matrix3d rotationFromZTo(const Eigen::Vector3d& axis) noexcept;

}  // namespace collision_monitor
