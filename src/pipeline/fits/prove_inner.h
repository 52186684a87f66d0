// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// Whether these shapes, from a file say, are inside a mesh: a sphere and a capsule as they are
/// named, one end of each core inside of a closed surface, and no triangle nearer to the core
/// than its radius, which clearanceBound proves. Takes microseconds, where to find them takes
/// milliseconds.
/// Limits: true for none at all. What is inside is told as MeshTree queries tell it: where the
/// surface goes around, in whatever direction.
bool areInside(const InnerShapes& inner, const MeshTree& tree);

}  // namespace collision_monitor
