// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles to look at: the surface of a shape in its body frame, counter-clockwise seen from
/// outside. Rounded parts are drawn with corners on the true surface, four to a quarter
/// circle, so the picture is up to 2 % of the radius smaller than the shape.
TriangleMesh surfaceOf(const Shape& shape);

}  // namespace collision_monitor
