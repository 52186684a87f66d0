// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// A closed polyhedron, facing outward, that holds the shape: a box's own surface, or up to 1 %
/// wider for round shapes.
/// Frames: that of the geometry. Units: metres. @pre the shape is valid; see checkGeometry.
TriangleMesh surroundingMesh(const Box& box);
TriangleMesh surroundingMesh(const Cylinder& cylinder);
TriangleMesh surroundingMesh(const Capsule& capsule);

}  // namespace collision_monitor
