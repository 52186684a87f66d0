// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// A surface, and a convex solid that holds it.
struct HeldSurface {
  const ConvexGeometry& around;
  const MeshTree* mesh;  ///< none: the solid itself is meant
  const Pose& world_from_body;
};

/// What is left of a query for the next one about the same two surfaces.
struct HullMemory {
  ConvexWarmStart& warm;
  TrianglePair& nearest;  ///< the last two triangles on which the solids were nearest
};

/// What the solids around two surfaces tell of the distance of these.
///
/// No point of a surface is nearer than the solid around it. Where the points at which the solids
/// are nearest lie on the surfaces, the surfaces are as near as the solids: `exact`. Meshes made
/// for collision checking are hulls but for a few hollows, and mostly end here, at a hundredth of
/// the cost of a search over triangles. Else `lower_bound`, or `unknown` where the solids meet.
///
/// Error: of what is exact as convex geometries, and 1e-13 of the sizes and the coordinates in the
/// world for points on a mesh.
/// Limits: `visits` counts nodes opened and triangles looked at. Half spaces are `unknown`.
/// Source: Ehmann, Lin, "Accurate and Fast Proximity Queries Between Polyhedra Using Convex Surface
/// Decomposition" (2001), for convex pieces as bounds; here each mesh is held by a single one.
/// @param stop_beyond as in MeshQueryLimits.
MeshDistance distanceByHulls(const HeldSurface& a, const HeldSurface& b, double stop_beyond,
                             MeshQueryMemory& memory, const HullMemory& last) noexcept;

}  // namespace collision_monitor
