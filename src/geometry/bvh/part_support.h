// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// The support function of a part of a mesh: the corner that is farthest in a direction. GJK then
/// measures the convex hull of the part, and nobody has to build the hull. Frames: the mesh's.
///
/// Looks at all corners; a vector instruction tests sixteen. Every instruction set gives the same
/// corner. Error: 1e-6 of the tree's radius, of the corner and of its reach.
/// @param node of a part, see MeshTree::partCorners. @param direction finite, not zero.
Eigen::Vector3d farthestOfPart(const MeshTree& mesh, std::uint32_t node,
                               const Eigen::Vector3d& direction) noexcept;

/// The error above, as a share of the tree's radius.
constexpr double kPartError = 1e-6;

}  // namespace collision_monitor
