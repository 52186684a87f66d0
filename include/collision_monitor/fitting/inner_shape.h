// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// Shapes inside a solid. Whatever overlaps one of them overlaps the solid.
struct InnerShapes {
  std::optional<PosedShape> sphere;   ///< holds a Sphere
  std::optional<PosedShape> capsule;  ///< holds a Capsule; its half length may be 0
};

/// Finds a large sphere and a capsule of large volume, both proven to be inside the geometry.
///
/// A mesh has an inside only if its surface is closed and consistent: once equal vertices are
/// merged and triangles with fewer than three vertices dropped, every edge belongs to exactly two
/// triangles, which run along it in opposite directions. If the enclosed volume is negative, all
/// triangles are turned. The inside is where the winding number is 1. It excludes cavities and the
/// overlap of two closed parts, where the mesh contradicts itself unless the overlap is intended.
///
/// Frames: geometry_from_body places the shapes in the geometry's frame. Units: metres.
/// Error: both are inside in exact arithmetic. One end of the core has winding number 1. The radius
/// is a lower bound of the core's distance to all triangles, which allows for rounding, less 1e-9
/// of the mesh's size. Neither is proven to be the largest: each is the best of several searches.
/// Limits: none for an open, inconsistent or flat mesh and for primitives without volume.
/// Source: medial start centers: Ma, Bae, Choi, "3D medial axis point approximation using nearest
/// neighbors and the normal field" (2012). Solid angles: van Oosterom, Strackee, "The Solid Angle
/// of a Plane Triangle" (1983).
/// @throws std::invalid_argument with a sentence: no vertices, a vertex that is not finite or
/// beyond 1e100, a triangle with a missing vertex, a dimension that is negative or not finite.
InnerShapes inscribeShapes(const Geometry& geometry);

}  // namespace collision_monitor
