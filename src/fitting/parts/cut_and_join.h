// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "fitting/proofs/distance_grid.h"

namespace collision_monitor {

/// Cuts of a surface, and which parts share a shape.
struct CutPlan {
  std::vector<PartCut> cuts;            ///< see Fit::cuts
  std::vector<std::uint32_t> shape_of;  ///< see Fit::shape_of
  std::size_t shapes{1};
};

/// Cuts a surface until each piece nearly fills its convex hull or there are many pieces. Then
/// joins pieces whose joint box is hardly larger than their own. For frames, rings, forks and
/// tables, where a cut only gains something once others follow.
///
/// The hollowest piece is cut next, where the boxes of both sides, and those with their scatter,
/// are smallest; in the middle if these are equal. Then the two pieces whose boxes grow least are
/// joined, until at most `most_shapes` are left and every further join would grow.
/// @param grid of the surface, in the geometry's frame.
/// @param target [m] pieces whose hull is no farther from the surface are not cut.
/// @pre most_shapes > 0.
/// Source: joining: Mamou, Ghorbel, "A Simple and Efficient Approach for 3D Mesh Approximate Convex
/// Decomposition" (2009); cutting where the hull is farthest from the surface: Lien, Amato,
/// "Approximate Convex Decomposition of Polyhedra" (2007).
CutPlan planCuts(const DistanceGrid& grid, std::size_t most_shapes, double target);

}  // namespace collision_monitor
