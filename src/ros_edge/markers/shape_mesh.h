// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles to look at: the surface of a shape in its body frame, counter-clockwise seen from
/// outside. Rounded parts are drawn with two to four corners to a quarter circle, which lie
/// outside, and middles of triangles inside, by up to 2 mm or, where that is more, 2 % of the
/// radius; lines of the grid touch the surface. Fewer corners are fewer bytes for who looks at
/// markers thirty times a second.
TriangleMesh surfaceOf(const Shape& shape);

}  // namespace collision_monitor
