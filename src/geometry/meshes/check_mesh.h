// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// [m] The largest length and coordinate that fits accept: cubes of lengths must be finite.
constexpr double kMaxLength = 1e100;

/// [m] The largest coordinate of a mesh that distances are measured to.
constexpr double kMaxMeasured = 1e6;

/// Checks a mesh.
/// @param most [m] the largest coordinate that is accepted
/// @throws std::invalid_argument for the first fault found, with a sentence that names the place
/// and what is accepted: no vertices, a coordinate that is not finite or beyond `most`, a
/// triangle with a missing vertex.
void checkMesh(const TriangleMesh& mesh, double most = kMaxLength);

}  // namespace collision_monitor
