// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The answer of a helper: vertices and triangles in their memory layout.
std::string toBytes(const TriangleMesh& mesh);

/// @throws std::runtime_error for bytes that are no mesh: a faulty helper may send anything.
TriangleMesh meshFromBytes(const std::string& bytes);

}  // namespace collision_monitor
