// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/convex_cases.h"

namespace collision_monitor::test {

/// Signed distance by other methods than the package's, with 64-bit mantissas. Slow.
///
/// Polyhedra (with points, segments and radii) by all their features. The largest gap over all face
/// normals and all cross products of edges decides, and is the depth. For shapes apart it tests all
/// vertices against triangles and all edges against edges.
/// A cylinder and a polyhedron by searches in one dimension over each pair of features.
/// Two cylinders by the largest gap over all directions: the best of a grid over the sphere are
/// refined by ever smaller grids. The result never exceeds the true signed distance; it falls short
/// by about 1e-7 of the sizes.
/// @return false for pairs with a half space, which have a closed form.
bool convexReference(const PosedConvexPair& pair, long double& distance);

}  // namespace collision_monitor::test
