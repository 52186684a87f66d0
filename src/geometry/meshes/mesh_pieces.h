// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// One corner of each connected piece of the surface: triangles that share vertices. For a mesh
/// without triangles, all vertices.
/// Limits: equal vertices connect only once they are merged, as readMesh does. Otherwise there are
/// more pieces than necessary.
/// @pre the vertices of all triangles exist.
std::vector<Eigen::Vector3d> piecesOf(const TriangleMesh& mesh);

}  // namespace collision_monitor
