// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles to look at: the surface of a shape in its body frame, counter-clockwise seen from
/// outside. Rounded parts have corners on the true surface, two to four to a quarter circle; lines
/// between those lie up to 2 mm or, where that is more, 2 % of the radius inside. Fewer corners are
/// fewer bytes for who looks at markers thirty times a second.
TriangleMesh surfaceOf(const Shape& shape);

}  // namespace collision_monitor
