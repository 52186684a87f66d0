// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Lists the corners of the parts of a mesh.
/// @param nodes of its tree, children behind their parents.
/// @param source by position in the tree: the number of the triangle, or of the vertex of a mesh
/// without triangles. @param center the origin of the nodes' frame.
PartCorners cornersOfParts(const TriangleMesh& mesh, const std::vector<MeshTreeNode>& nodes,
                           const std::vector<std::uint32_t>& source, const Eigen::Vector3d& center);

}  // namespace collision_monitor
