// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Of the hull's extent: triangles this near to its surface count as on it. Coordinates that were
/// stored as float are rounded by less.
constexpr double kConvexTolerance = 2e-7;

/// True when a closed mesh is the surface of its hull, up to kConvexTolerance: what is measured
/// between hulls then holds for the mesh.
///
/// Every triangle has all corners on one face of the hull; a closed surface that lies in a surface
/// like a sphere's covers it whole.
/// Limits: false for meshes of more than 1e7 triangles times faces, where looking takes too long.
/// @pre the mesh is closed and the hull its own.
bool isSurfaceOf(const TriangleMesh& mesh, const ConvexHull& hull);

}  // namespace collision_monitor
