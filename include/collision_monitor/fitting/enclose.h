// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// One shape that encloses one geometry, proven.
struct Enclosure {
  Shape shape;
  Pose geometry_from_body;  ///< where the shape sits in the geometry's frame
  Overshoot overshoot;
  double widening{0.0};  ///< [m] growth of the radius or extents that the proof asked for
  bool is_exact{false};  ///< the shape is the geometry: distances to it are exact
};

/// Kinds of shape that may be chosen.
struct ShapeKinds {
  bool sphere{true};
  bool capsule{true};
  bool box{true};
  bool rounded_box{true};
};

/// Whether a shape is of one of the kinds.
bool isAmong(const ShapeKinds& kinds, const Shape& shape) noexcept;

/// The tightest of sphere, capsule, oriented box and rounded box that encloses the geometry.
/// Spheres, capsules and boxes are returned as they are, where their kind is allowed.
///
/// Tightest means: least fourth-power mean of the overshoot; a costlier kind (in the order above)
/// has to be 3 % better. docs/decisions/choice-of-shape.md says why.
///
/// Error: containment of every vertex (for curved geometry: of the geometry by
/// its farthest points) is proven with rounding taken into account; a fit that
/// cannot be proven is widened until it can.
/// Vertices that no triangle uses are enclosed too.
/// Limits: flat, one-segment and one-point meshes are legal, with or without triangles; so are
/// open, inverted and self-intersecting ones. Coordinates and dimensions up to 1e100 m.
/// @throws std::invalid_argument with a sentence that names the fault: no
/// vertices, a non-finite or too large vertex or dimension, a negative dimension, a triangle that
/// names a vertex that is not there, no kind that is allowed.
Enclosure encloseTightly(const Geometry& geometry, const ShapeKinds& kinds = {});

}  // namespace collision_monitor
