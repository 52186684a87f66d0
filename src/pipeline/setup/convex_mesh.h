// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles this near to the hull's surface count as on it, as a share of the hull's extent.
/// Coordinates stored as float are rounded by less.
constexpr double kConvexTolerance = 2e-7;

/// True if a closed mesh is the surface of its hull, up to kConvexTolerance. Distances of the hull
/// then hold for the mesh.
///
/// Tests that every triangle has all corners on one face of the hull. A closed surface within a
/// surface like that of a sphere covers it completely.
/// Limits: false if triangles times faces exceed 1e7, where the test takes too long.
/// @pre the mesh is closed and `hull` is its hull.
bool isSurfaceOf(const TriangleMesh& mesh, const ConvexHull& hull);

}  // namespace collision_monitor
