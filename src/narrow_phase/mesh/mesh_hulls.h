// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// A surface, and a convex solid that encloses it.
struct HeldSurface {
  const ConvexGeometry& around;
  const MeshTree* mesh;  ///< null: the solid itself counts
  const Pose& world_from_body;
};

/// What a query leaves for the next one about the same two surfaces.
struct HullMemory {
  ConvexWarmStart& warm;
  TrianglePair& nearest;  ///< the last two triangles at which the solids were nearest
};

/// How far a query goes.
struct HullGoal {
  double stop_beyond;     ///< [m] as in MeshQueryLimits
  double tolerance{0.0};  ///< [m] as in MeshQueryLimits
  /// False: it only matters whether they are farther apart than `stop_beyond`. The search ends at
  /// the first plane that shows this, and does not try first whether the last nearest points still
  /// are.
  bool asks_nearest{true};
};

/// Finds what the solids around two surfaces say about the distance of the surfaces.
///
/// A surface is never nearer than the solid around it. If the nearest points of the solids lie on
/// the surfaces, the distances are equal: `exact`. Meshes made for collision checking are hulls
/// except for a few hollows, and mostly end here, at a hundredth of the cost of a search over
/// triangles. Otherwise the answer is `lower_bound`, or `unknown` if the solids meet.
///
/// Error: if exact, that of convex geometries, plus 1e-13 of the sizes and the world coordinates
/// for points on a mesh.
/// Limits: `visits` counts nodes opened and triangles looked at. Half spaces are `unknown`.
/// Source: Ehmann, Lin, "Accurate and Fast Proximity Queries Between Polyhedra Using Convex Surface
/// Decomposition" (2001), for convex pieces as bounds. Departure: one piece holds each mesh.
/// Within the tolerance the nearest points are those of the solids, and `shortfall` is how far the
/// surfaces are from both together.
MeshDistance distanceByHulls(const HeldSurface& a, const HeldSurface& b, const HullGoal& goal,
                             MeshQueryMemory& memory, const HullMemory& last) noexcept;

}  // namespace collision_monitor
