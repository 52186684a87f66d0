// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The largest length and coordinate that fits accept: cubes of lengths must be finite. [m]
constexpr double kMaxLength = 1e100;

/// @throws std::invalid_argument with a sentence that names the place and what is accepted, for the
/// first fault found: no vertices, a coordinate that is not finite or beyond kMaxLength, a triangle
/// that names a vertex that is not there.
void checkMesh(const TriangleMesh& mesh);

}  // namespace collision_monitor
