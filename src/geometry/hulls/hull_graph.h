// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// By vertex: the vertices that a climb looks at from there, in ascending order. They are those at
/// the other ends of edges, and for vertices that short edges join, those of each of them.
///
/// A climb stops where no neighbour gains more than rounding, about 1e-16 of the extent. Along a
/// short edge that is a slope which the rest of the hull might exploit; seen from all vertices of
/// such a cluster at once, only its long edges lead up.
/// @param extent [m] of the hull.
/// @return an empty list for hulls without triangles, and for those of little but short edges.
std::vector<std::vector<std::uint32_t>> neighboursToClimb(const TriangleMesh& hull, double extent);

}  // namespace collision_monitor
