// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Triangles, as positions in the polygon, that cover every point the polygon winds
/// around: its inside, and both lobes of one that crosses itself. Corners in the order of
/// the polygon, so that the winding stays.
///
/// A polygon that does not cross itself, notched or not, is covered exactly; one that
/// does may be covered with more than itself, never beyond its convex hull.
/// Limits: corners that are not quite in one plane are looked at along their mean normal.
/// Source: ear clipping as in O'Rourke, "Computational Geometry in C" (1998), section 1.6;
/// mean normal by Newell's method. assimp's own triangulation is not used because it drops
/// triangles below an absolute area, which in metres is a few millimetres.
/// @pre at least three corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Eigen::Vector3d>& polygon);

}  // namespace collision_monitor
