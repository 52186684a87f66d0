// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace collision_monitor {

/// The corners of a hull that encloses a cone with its apex up, about the middle of its axis. The
/// sides of a polygon around the base touch its circle.
std::vector<Eigen::Vector3d> cornersAroundCone(double radius, double half_length);

}  // namespace collision_monitor
