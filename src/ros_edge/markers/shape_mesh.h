// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Triangles for display: the surface of a shape in its body frame, counter-clockwise seen from
/// outside. Rounded parts have two to four corners per quarter circle. Corners are outside the
/// surface and centers of triangles inside, by up to 2 mm or 2 % of the radius, whichever is more;
/// grid lines are tangent to it. Few corners keep messages small: listeners get them thirty times a
/// second.
TriangleMesh surfaceOf(const Shape& shape);

}  // namespace collision_monitor
