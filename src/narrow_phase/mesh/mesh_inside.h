// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/narrow_phase/mesh_distance.h"

namespace collision_monitor {

/// True when the closed surface goes around the point, at least once and in either direction.
///
/// Looks up along z and adds the triangles above the point, each with the sign of its turn.
/// Whether a triangle covers the point is put together from its edges, and two triangles that
/// share an edge take the same answer from it: a line of sight through an edge or a
/// corner is counted right.
/// Frames: the mesh's. Error: points on the surface, within rounding, may get either answer.
/// Source: Sunday, "Inclusion of a Point in a Polygon" (2001), for the signed crossings.
bool isInside(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
