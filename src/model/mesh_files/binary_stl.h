// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The triangles of a binary STL, in the form of readMesh. Its records have a fixed size and refer
/// to nothing, so no file can crash or stall this function. It needs no separate process. Takes at
/// most a few times the memory of the file.
/// @throws std::runtime_error if the file ends before its triangles do, or a vertex is not finite.
/// @pre isTextStl says no.
TriangleMesh readBinaryStl(const std::string& bytes);

}  // namespace collision_monitor
