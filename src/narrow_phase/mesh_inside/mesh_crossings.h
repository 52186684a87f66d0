// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// What a line of sight meets.
struct Crossings {
  int turns{0};             ///< triangles seen from behind, less those seen from the front
  std::uint32_t visits{0};  ///< nodes and triangles looked at
};

/// Looks from a point along (slope, 1). A closed surface goes around the point as many times as the
/// line crosses it.
///
/// Edges decide whether a triangle covers the point. Two triangles get the same answer from an edge
/// that they share, so a line of sight through an edge or a corner is counted right.
/// Frames: the mesh's. Error: points on the surface, within rounding, may get either answer.
/// Source: Sunday, "Inclusion of a Point in a Polygon" (2001), for the signed crossings.
Crossings crossingsAbove(const MeshTree& tree, const Eigen::Vector3d& point,
                         const Eigen::Vector2d& slope, MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
