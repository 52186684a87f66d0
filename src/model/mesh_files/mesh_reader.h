// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles of a mesh file given as bytes: STL (ASCII and binary, also a binary one
/// whose header says "solid"), DAE, OBJ, PLY. All nodes are placed by their transforms.
///
/// Units: DAE's unit is applied; coordinates of other formats are metres as they are.
/// Frames: the axes of the file. The up axis of a DAE is left alone, as rviz and
/// MoveIt do, so that what is checked is what is seen (docs/decisions/mesh-up-axis.md).
/// Shape: polygons become triangles and equal vertices one. Triangles without
/// area are left out of `triangles`, but their corners stay in `vertices`: what
/// encloses the vertices encloses all that the file draws. Vertices of no polygon,
/// points and lines have no surface and are left out.
/// Error: coordinates carry the rounding of float, 6e-8 of their size.
/// Limits: a mesh whose triangles all lack area has vertices only. A polygon that
/// crosses itself is covered by a fan, which never misses a part of it.
///
/// `file_name` serves to tell the format by its extension, and to name the file in errors.
/// @throws std::runtime_error with a sentence: a format that is not read, a file that is
/// empty, malformed or cut short, no polygons, a vertex that is not finite.
TriangleMesh readMesh(const std::string& bytes, const std::string& file_name);

/// Whether readMesh does without assimp, and so can neither crash nor be kept busy: of a binary
/// STL.
bool isReadWithoutAssimp(const std::string& bytes, const std::string& file_name);

}  // namespace collision_monitor
