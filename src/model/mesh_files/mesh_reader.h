// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles of a mesh file given as bytes: STL (ASCII and binary, also a binary one whose header
/// says "solid"), DAE, OBJ, PLY. The transforms of all nodes are applied.
///
/// Units: DAE's unit is applied; coordinates of other formats are taken as metres.
/// Frames: the axes of the file. The up axis of a DAE is ignored, as in rviz and MoveIt, so that
/// the checked mesh is the displayed one (docs/decisions/mesh-up-axis.md).
/// Shape: polygons become triangles, and equal vertices are merged. Triangles without area are the
/// segments and points that they cover, unless edges of others hold these: addFlatTriangles.
/// Vertices without a polygon, points and lines have no surface and are left out.
/// Error: coordinates have the rounding of float, 6e-8 of their size.
/// Limits: a polygon that crosses itself is covered by a fan, which never misses a part of it.
///
/// @param file_name its extension gives the format; errors name the file
/// @throws std::runtime_error with a sentence: an unsupported format, a file that is empty,
/// malformed or cut short, no polygons, a vertex that is not finite.
TriangleMesh readMesh(const std::string& bytes, const std::string& file_name);

/// Whether readMesh reads this file without assimp, and thus can neither crash nor stall: only for
/// binary STLs.
bool isReadWithoutAssimp(const std::string& bytes, const std::string& file_name);

}  // namespace collision_monitor
