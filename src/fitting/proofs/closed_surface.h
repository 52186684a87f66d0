// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/geometry/triangle_bvh.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The surface as the boundary of a solid: equal vertices are merged, triangles with two equal
/// corners dropped, and the whole faces outward. None if an edge is not shared by exactly two
/// triangles in opposite directions, or if the volume is below 1e-12 of the cubed size.
/// @pre the mesh is valid.
std::optional<TriangleMesh> closedSurface(const TriangleMesh& mesh);

/// How many times the surface goes around the point, from the solid angles of its triangles. Error:
/// the true value for a closed surface is a whole number; the sum errs by about 1e-16 per triangle.
/// @pre the point is not on the surface.
double windingNumber(const TriangleBvh& surface, const Eigen::Vector3d& point) noexcept;

}  // namespace collision_monitor
