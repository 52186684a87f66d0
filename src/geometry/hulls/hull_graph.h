// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// By vertex: the vertices that a climb tests from there, in ascending order. They are the other
/// ends of its edges. Vertices joined by short edges share the neighbours of all of them.
///
/// A climb stops where no neighbour gains more than rounding, about 1e-16 of the extent. On a short
/// edge that gain is a slope along which the rest of the hull might still rise. Seen from all
/// vertices of such a cluster at once, only its long edges lead up.
/// @param extent [m] of the hull.
/// @return an empty list for hulls without triangles, and for those of hardly any long edges.
std::vector<std::vector<std::uint32_t>> neighboursToClimb(const TriangleMesh& hull, double extent);

}  // namespace collision_monitor
