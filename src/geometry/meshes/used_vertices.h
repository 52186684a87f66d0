// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The mesh without the vertices that no triangle uses. They are no part of its surface.
/// @return nothing if there are none to leave out: all are used, or the mesh has no triangles and
/// its vertices are points. The order of triangles stays.
/// @pre the corners of triangles are below the number of vertices
std::optional<TriangleMesh> withoutUnusedVertices(const TriangleMesh& mesh);

}  // namespace collision_monitor
