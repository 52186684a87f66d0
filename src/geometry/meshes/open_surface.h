// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// What an open surface needs, but for its hull. @param tree of the surface
OpenSurface openSurfaceOf(const TriangleMesh& oriented, const MeshTree& tree);

/// See MeshTree::probes.
std::vector<Eigen::Vector3d> probesOf(const std::vector<Eigen::Vector3d>& pieces,
                                      const std::vector<Triangle>& triangles);

}  // namespace collision_monitor
