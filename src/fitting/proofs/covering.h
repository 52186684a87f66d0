// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// A geometry and its pose in the link frame.
struct PlacedGeometry {
  Pose link_from_geometry;
  const Geometry* geometry{nullptr};
};

/// Whether a union of shapes covers geometry.
struct Covering {
  bool is_proven{false};
  double widening{0.0};  ///< [m] growth of each shape that the proof needs
  /// If not proven: the point found that lies farthest outside.
  Eigen::Vector3d farthest{Eigen::Vector3d::Zero()};  ///< link frame
  double excess{0.0};                                 ///< [m] its distance to the nearest shape
  std::size_t geometry{0};                            ///< the geometry it belongs to
};

/// Proves that every point of every geometry's surface lies in one of the shapes. All shapes are
/// grown by one length, 0 if possible and at most `max_widening`.
///
/// A convex shape that holds the corners of a triangle holds the triangle. A triangle in no single
/// shape is divided until its parts are in one or are too small to matter. Where shapes only touch,
/// a little growth makes them overlap. A prism with 1024 sides replaces a cylinder (5e-6 of the
/// radius wider); a polyhedron replaces a sphere or capsule in no single shape (1 %).
///
/// Frames: shapes in the link frame.
/// Error: proven in exact arithmetic, rounding included, as provenExcess. "Not proven" does not
/// mean that there is a hole: the search ends after some millions of parts.
/// Limits: only the surface is tested, not the inside, as in fitGeometries.
/// @pre geometries are valid; there is a shape; shapes are finite and rigid.
Covering proveCovering(const std::vector<PlacedGeometry>& geometries,
                       const std::vector<PosedShape>& shapes, double max_widening);

}  // namespace collision_monitor
