// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The triangles of a binary STL, as readMesh gives them. Its records are all of one size and name
/// nothing, so no file keeps this busy or leads it astray: it needs no process of its own.
/// Takes at most a few times the memory of the file.
/// @throws std::runtime_error if the file ends before its triangles do, or a vertex is not finite.
/// @pre isTextStl says no.
TriangleMesh readBinaryStl(const std::string& bytes);

}  // namespace collision_monitor
