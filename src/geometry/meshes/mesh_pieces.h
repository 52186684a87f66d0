// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// One corner of each connected piece of the surface: of triangles that share vertices. Of a mesh
/// without triangles, all vertices.
/// Limits: equal vertices connect only if they are one, as readMesh leaves them; else there are
/// more pieces than need be.
/// @pre triangles name vertices that are there.
std::vector<Eigen::Vector3d> piecesOf(const TriangleMesh& mesh);

}  // namespace collision_monitor
