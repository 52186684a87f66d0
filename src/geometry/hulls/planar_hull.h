// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// The convex polygon of 2-D points as indices, counter-clockwise, without collinear corners.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions" (1979).
std::vector<std::uint32_t> convexPolygonOf(const std::vector<Eigen::Vector2d>& points);

/// The polygon of points in a plane with unit `normal`, as a fan of triangles on both sides.
std::vector<std::array<std::uint32_t, 3>> planarHull(const std::vector<Eigen::Vector3d>& points,
                                                     const Eigen::Vector3d& normal);

}  // namespace collision_monitor
