// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/inner_shape.h"

namespace collision_monitor {

/// Limits on the number and the tightness of the shapes of one link.
struct FitLimits {
  /// For all geometries of the link together; each geometry has at least one shape. The cost of a
  /// cycle grows with the product of two links' shapes.
  std::uint32_t max_shapes{1};
  double target_overshoot{0.0};  ///< [m] a part that sticks out no farther is not divided
  ShapeKinds kinds;              ///< of shape that may be chosen
};

/// A cut of one part of a surface in two. The part keeps what is below the plane
/// { x : normal . x = offset }. What is above becomes the part with the next number.
struct PartCut {
  std::uint32_t part{0};  ///< which part is cut; part 0 is the whole surface
  Eigen::Vector3d normal{Eigen::Vector3d::UnitX()};  ///< unit, in the geometry's frame
  double offset{0.0};                                ///< [m]
};

/// The shapes of one geometry.
struct Fit {
  std::vector<Enclosure> shapes;  ///< which together enclose the surface
  std::vector<PartCut> cuts;      ///< in the order in which they were made; one fewer than parts
  /// By part: the shape that holds it. Empty: each part has its own shape, in the same order.
  std::vector<std::uint32_t> shape_of;
  /// Overshoot of the union of the shapes: over the points of each shape that no other holds.
  Overshoot overshoot;
  InnerShapes inner;  ///< inside the geometry; none if not searched for
  /// The openness of a mesh that is not closed, see opennessOf; none if not measured.
  std::optional<double> openness;
};

/// Encloses each geometry in one or more shapes. The part that sticks out farthest is cut first, so
/// shapes go where they are needed. Triangles that a plane crosses are cut too.
///
/// Every part of a surface lies in its own shape, so the whole surface lies in the union. The space
/// behind a surface is covered only by the parts' convex hulls: three or more cuts of a closed mesh
/// may leave a hollow where they meet.
/// Error: as encloseTightly; corners that a cut makes are allowed for, see PartedSurface.
/// @return one fit per geometry.
/// @throws std::invalid_argument as encloseTightly, and when max_shapes is 0 or target_overshoot is
/// negative or NaN.
std::vector<Fit> fitGeometries(const std::vector<Geometry>& geometries, const FitLimits& limits);

/// An upper bound of how far the geometry lies outside the fit, valid in exact arithmetic.
/// A value <= 0 proves that the union encloses the geometry. For fits read from a file.
/// Limits: infinity when the fit is malformed (no shapes, cuts of missing parts, normals that are
/// not unit, numbers that are not finite).
double provenExcess(const Geometry& geometry, const Fit& fit);

}  // namespace collision_monitor
