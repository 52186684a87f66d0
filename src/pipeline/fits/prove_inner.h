// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// Whether shapes (of a file, for example) are inside a mesh: `sphere` is a sphere and `capsule` a
/// capsule, one end of each core is inside a closed surface, and no triangle is nearer to the core
/// than its radius, by clearanceBound. Takes microseconds; finding the shapes takes milliseconds.
/// Limits: true if there are no shapes. Inside is where the surface winds around a point, in either
/// direction, as in MeshTree queries.
bool areInside(const InnerShapes& inner, const MeshTree& tree);

}  // namespace collision_monitor
