// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// OpenSurface::moments for the nodes and triangles of a tree.
std::vector<WindingMoments> momentsOf(const std::vector<MeshTreeNode>& nodes,
                                      const std::vector<Triangle>& triangles);

/// The open surface without its moments.
OpenSurface openSurfaceOf(const TriangleMesh& oriented);

/// See MeshTree::probes.
std::vector<Eigen::Vector3d> probesOf(const std::vector<Eigen::Vector3d>& pieces,
                                      const std::vector<Triangle>& triangles);

}  // namespace collision_monitor
