// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// A geometry and its place in the frame of the link.
struct PlacedGeometry {
  Pose link_from_geometry;
  const Geometry* geometry{nullptr};
};

/// Whether a union of shapes covers geometry.
struct Covering {
  bool is_proven{false};
  double widening{0.0};  ///< [m] growth of each shape that the proof asks for
  /// Where it is not proven: the point found that lies farthest outside.
  Eigen::Vector3d farthest{Eigen::Vector3d::Zero()};  ///< link frame
  double excess{0.0};                                 ///< [m] its distance to the nearest shape
  std::size_t geometry{0};                            ///< the geometry it belongs to
};

/// Proves that every point of every geometry's surface lies in one of the shapes, each grown by
/// one and the same length that is 0 if possible and at most `max_widening`.
///
/// A triangle lies in a convex shape with its corners. One that lies in none is halved until its
/// parts do, or are too small to matter; where shapes only touch, a little growth makes them
/// overlap. Cylinders are replaced by a prism around them with 1024 sides (5e-6 of the radius),
/// spheres and capsules that lie in no single shape by a polyhedron around them (1 %).
///
/// Frames: shapes in the link frame, in place of the geometry's.
/// Error: proven in exact arithmetic, rounding included, as provenExcess. Not proven does not
/// mean that there is a hole: the search ends after some millions of parts.
/// Limits: the surface is looked at, not the inside, as in fitGeometries.
/// @pre geometries are sound; shapes are finite, rigid and at least one.
Covering proveCovering(const std::vector<PlacedGeometry>& geometries,
                       const std::vector<PosedShape>& shapes, double max_widening);

}  // namespace collision_monitor
