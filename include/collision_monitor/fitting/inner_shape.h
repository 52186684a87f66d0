// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// Shapes inside a solid: what overlaps one of them overlaps the solid.
struct InnerShapes {
  std::optional<PosedShape> sphere;   ///< holds a Sphere
  std::optional<PosedShape> capsule;  ///< holds a Capsule; its half length may be 0
};

/// A large sphere and a capsule of large volume inside a geometry, proven to be inside.
///
/// A mesh has an inside only if its surface is closed and consistent: after equal vertices are made
/// one and triangles on two vertices left out, every edge has exactly two triangles, which run
/// along it in opposite directions. If the enclosed volume is negative, all triangles are turned.
/// Inside are the points with winding number 1: not the cavities, and not what a closed part has
/// in common with another, where the mesh contradicts itself unless parts overlap on purpose.
///
/// Frames: geometry_from_body places the shapes in the geometry's frame. Units: metres.
/// Error: both are inside in exact arithmetic: one end of the core has winding number 1, and no
/// point of the core is nearer to a triangle than the radius, which is a lower bound that allows
/// for rounding, less 1e-9 of the mesh's size. That they are the largest is not proven: each is
/// the best of several local searches.
/// Limits: none for an open, inconsistent or flat mesh and for primitives without volume.
/// Source: centers to start from are medial: Ma, Bae, Choi, "3D medial axis point approximation
/// using nearest neighbors and the normal field" (2012). Solid angles: van Oosterom, Strackee,
/// "The Solid Angle of a Plane Triangle" (1983).
/// @throws std::invalid_argument with a sentence: no vertices, a vertex that is not finite or
/// beyond 1e100, a triangle without its vertices, a dimension that is negative or not finite.
InnerShapes inscribeShapes(const Geometry& geometry);

}  // namespace collision_monitor
