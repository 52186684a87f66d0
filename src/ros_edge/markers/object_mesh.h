// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Most triangles of an object's mesh that are drawn. Listeners get them thirty times a second.
constexpr std::size_t kMostDrawn = 4000;

/// Triangles for display: a cone, in its frame.
TriangleMesh surfaceOf(const Cone& cone);

/// Triangles for display: the mesh itself or, if it has more than `most` triangles, a coarse one
/// whose vertices are within a cell of a grid of those of the mesh.
TriangleMesh coarseMesh(const TriangleMesh& mesh, std::size_t most);

}  // namespace collision_monitor
