// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Triangles, as indices of corners, that cover every point with a non-zero winding number: the
/// inside, and both lobes of a polygon that crosses itself. Corners keep the order of the polygon,
/// and thus its winding.
///
/// A polygon that does not cross itself is covered exactly, convex or not. For one that does, the
/// triangles may cover more, but never beyond its convex hull.
/// Limits: corners that are not quite in one plane are projected along their mean normal.
/// Source: ear clipping as in O'Rourke, "Computational Geometry in C" (1998), section 1.6; mean
/// normal by Newell's method. assimp's own triangulation is not used: it drops triangles below an
/// absolute area, which for metres means edges of a few millimetres.
/// @pre at least three corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Eigen::Vector3d>& polygon);

}  // namespace collision_monitor
