// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/triangle/triangle_triangle.h"

/// A triangle (A) and a solid box (B) about the origin. Frames: the box's.
namespace collision_monitor {

/// As nearestPoints of a triangle and a core. @param half_extents [m], >= 0
PointPair nearestToBox(const Triangle& triangle, const Eigen::Vector3d& half_extents,
                       const PointPair& start) noexcept;

/// A direction from the triangle to the box, normal to an edge of each, that separates them by the
/// cutoff; zero if there is none.
/// @param squared_cutoff [m^2] @return of any length
/// Source: Akenine-Moller, "Fast 3D Triangle-Box Overlap Testing" (2001), for the nine axes.
Eigen::Vector3d acrossEdges(const Triangle& triangle, const Eigen::Vector3d& half_extents,
                            double squared_cutoff) noexcept;

}  // namespace collision_monitor
