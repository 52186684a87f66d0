// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Triangles of the hull of points that span space, outward; none when qhull fails.
/// qhull works on (points - center) / extent: its tolerances then mean the same at every scale.
std::vector<std::array<std::uint32_t, 3>> runQhull(const std::vector<Eigen::Vector3d>& points,
                                                   const Eigen::Vector3d& center, double extent);

}  // namespace collision_monitor
