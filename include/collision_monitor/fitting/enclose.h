// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// One shape that is proven to enclose one geometry.
struct Enclosure {
  Shape shape;              ///< without padding, in its own body frame
  Pose geometry_from_body;  ///< places the shape in the geometry's frame
  Overshoot overshoot;      ///< [m] of the shape over the geometry
  double widening{0.0};     ///< [m] growth of the radius or extents that the proof needed
  bool is_exact{false};     ///< the shape equals the geometry, so distances to it are exact
};

/// Kinds of shape that may be chosen.
struct ShapeKinds {
  bool sphere{true};       ///< Sphere may be chosen
  bool capsule{true};      ///< Capsule may be chosen
  bool box{true};          ///< Box may be chosen
  bool rounded_box{true};  ///< RoundedBox may be chosen
};

/// Whether a shape is of one of the kinds.
bool isAmong(const ShapeKinds& kinds, const Shape& shape) noexcept;

/// The tightest sphere, capsule, oriented box or rounded box that encloses the geometry. A sphere,
/// capsule or box is returned unchanged where its kind is allowed.
///
/// The tightest shape has the least fourth-power mean of the overshoot. A costlier kind (in the
/// order above) has to be 3 % better: see docs/decisions/choice-of-shape.md.
///
/// Error: containment is proven with rounding taken into account, for every vertex of a mesh (used
/// by a triangle or not) and for the farthest points of curved geometry. A fit that cannot be
/// proven is widened until it can.
/// Limits: flat, one-segment and one-point meshes are legal, with or without triangles. So are
/// open, inverted and self-intersecting ones. Coordinates and dimensions up to 1e100 m.
/// @throws std::invalid_argument with a sentence that names the fault: no vertices, a vertex or
/// dimension that is not finite or too large, a negative dimension, a triangle with a missing
/// vertex, no allowed kind.
Enclosure encloseTightly(const Geometry& geometry, const ShapeKinds& kinds = {});

}  // namespace collision_monitor
