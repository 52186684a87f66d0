// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles of a mesh file given as bytes: STL (ASCII and binary, also a binary one
/// whose header says "solid"), DAE, OBJ, PLY. All nodes are placed by their transforms.
///
/// Units: DAE's unit is applied; the up axis is left alone, as rviz and MoveIt do,
/// so that what is checked is what is seen.
/// `file_name` serves to tell the format and to name the file in errors.
/// @throws std::runtime_error with a sentence: unreadable, no triangles, non-finite vertex.
TriangleMesh readMesh(const std::string& bytes, const std::string& file_name);

}  // namespace collision_monitor
