// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// What a helper answers: vertices and triangles as they lie in memory.
std::string toBytes(const TriangleMesh& mesh);

/// @throws std::runtime_error for bytes that are no mesh: a helper that went wrong may send any.
TriangleMesh meshFromBytes(const std::string& bytes);

}  // namespace collision_monitor
