// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Most triangles that are drawn: of one mesh, and of all meshes of objects. Listeners get them
/// thirty times a second; each takes 72 bytes.
constexpr std::size_t kMostDrawn = 4000;
constexpr std::size_t kMostDrawnOfAll = 20000;

/// Triangles for display: a cone, in its frame.
TriangleMesh surfaceOf(const Cone& cone);

/// Triangles for display: the mesh itself or, if it has more than `most` triangles, a coarse one
/// whose vertices are within a cell of a grid of those of the mesh.
TriangleMesh coarseMesh(const TriangleMesh& mesh, std::size_t most);

/// What is drawn of a mesh.
struct DrawnMesh {
  SharedMesh fine;      ///< of at most kMostDrawn triangles
  SharedMesh drawn;     ///< of at most `most` triangles; none if so few cannot show it
  std::size_t most{0};  ///< depends on the other meshes
};

using DrawnMeshes = std::map<SharedMesh, DrawnMesh>;  ///< by the object's mesh

/// What is drawn of all meshes of a world. They share kMostDrawnOfAll: meshes of few triangles are
/// drawn whole, larger ones coarsely. Works on all processors, since that may take seconds.
/// @param former gives what stays as it was
/// @throws Interrupted
DrawnMeshes drawMeshes(const World& world, const DrawnMeshes& former);

}  // namespace collision_monitor
