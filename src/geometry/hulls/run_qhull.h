// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// The triangles of the hull of points that span space, facing outward; none when qhull fails.
/// qhull works on (points - center) / extent, so its tolerances mean the same at every scale.
std::vector<std::array<std::uint32_t, 3>> runQhull(const std::vector<Eigen::Vector3d>& points,
                                                   const Eigen::Vector3d& center, double extent);

}  // namespace collision_monitor
