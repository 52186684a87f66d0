// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/geometry/triangle_bvh.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The surface as one that bounds a solid: equal vertices made one, triangles on two vertices left
/// out, outward as a whole. Nothing when an edge is not shared by exactly two triangles in opposite
/// directions, or when the enclosed volume is below 1e-12 of the cubed size.
/// @pre the mesh is sound.
std::optional<TriangleMesh> closedSurface(const TriangleMesh& mesh);

/// How many times the surface goes around the point, from the solid angles of its triangles.
/// Error: for a closed surface the true value is a whole number, from which the sum departs by
/// about 1e-16 a triangle. @pre the point is not on the surface.
double windingNumber(const TriangleBvh& surface, const Eigen::Vector3d& point) noexcept;

}  // namespace collision_monitor
