// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The content of one `<collision>` element of a URDF, in its own frame, with scale applied.
using Geometry = std::variant<Sphere, Capsule, Box, Cylinder, TriangleMesh>;

}  // namespace collision_monitor
