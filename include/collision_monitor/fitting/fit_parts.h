// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/inner_shape.h"

namespace collision_monitor {

/// What the shapes of one link may cost, and how tight they have to be.
struct FitLimits {
  /// Of all geometries of the link together; each geometry has at least one. The cost of a cycle
  /// grows with the product of two links' shapes.
  std::uint32_t max_shapes{1};
  double target_overshoot{0.0};  ///< [m] a part that sticks out no farther is not divided
  ShapeKinds kinds;
};

/// A cut of one part of a surface in two. The part keeps what is below the plane
/// { x : normal . x = offset }; what is above becomes the part with the next number.
struct PartCut {
  std::uint32_t part{0};
  Eigen::Vector3d normal{Eigen::Vector3d::UnitX()};  ///< unit, in the geometry's frame
  double offset{0.0};                                ///< [m]
};

/// The shapes of one geometry.
struct Fit {
  std::vector<Enclosure> shapes;
  std::vector<PartCut> cuts;  ///< in the order in which they were made; one less than parts
  /// By part: the shape that holds it; empty: each part has its own, in the same order.
  std::vector<std::uint32_t> shape_of;
  /// Of the union of the shapes: over the points of each that no other holds.
  Overshoot overshoot;
  InnerShapes inner;  ///< in the geometry; none where nobody looked for them
  /// Of a mesh that is not closed, as opennessOf measures it; none where nobody did.
  std::optional<double> openness;
};

/// Encloses each geometry in one or more shapes. The part that sticks out farthest is cut first, so
/// that shapes are spent where they are needed; triangles that a plane crosses are cut too.
///
/// Every part of a surface lies in its own shape, and so the whole surface in the union. What lies
/// behind a surface is covered as far as the parts' convex hulls reach: a closed mesh that is cut
/// by three planes or more may leave a hollow where they meet.
/// Error: as for encloseTightly; corners that a cut makes are allowed for, see PartedSurface.
/// @return one a geometry.
/// @throws std::invalid_argument as encloseTightly; when max_shapes is 0, or target_overshoot
/// negative or NaN.
std::vector<Fit> fitGeometries(const std::vector<Geometry>& geometries, const FitLimits& limits);

/// An upper bound of how far the geometry lies outside the fit, valid in exact arithmetic: <= 0
/// proves that the union encloses it. For fits that come from a file.
/// Limits: infinity when the fit is malformed (no shapes, cuts of parts that are not there or with
/// normals that are not unit, numbers that are not finite).
double provenExcess(const Geometry& geometry, const Fit& fit);

}  // namespace collision_monitor
