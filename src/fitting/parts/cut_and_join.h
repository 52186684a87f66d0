// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "fitting/proofs/distance_grid.h"

namespace collision_monitor {

/// Cuts of a surface, and which of the parts share a shape.
struct CutPlan {
  std::vector<PartCut> cuts;            ///< as Fit::cuts
  std::vector<std::uint32_t> shape_of;  ///< as Fit::shape_of
  std::size_t shapes{1};
};

/// Cuts a surface until each piece nearly fills its convex hull, or there are many, and joins again
/// what has a common box hardly larger than its own: for frames, rings, forks and tables, where
/// a cut is worth nothing before others have followed.
///
/// The hollowest piece is cut, where the boxes of both sides, and those with their scatter, are
/// smallest; in the middle, if that is all the same. Then the two pieces are joined whose boxes
/// grow least, until there are no more than `most_shapes` and the next would grow.
/// @param grid of the surface, in the geometry's frame.
/// @param target [m] pieces whose hull is no farther from the surface are not cut.
/// @pre most_shapes > 0.
/// Source: Mamou, Ghorbel, "A Simple and Efficient Approach for 3D Mesh Approximate Convex
/// Decomposition" (2009), for joining; Lien, Amato, "Approximate Convex Decomposition of Polyhedra"
/// (2007), for cutting where the hull is farthest from the surface.
CutPlan planCuts(const DistanceGrid& grid, std::size_t most_shapes, double target);

}  // namespace collision_monitor
