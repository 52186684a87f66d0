// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Nothing for geometries that are not of the family of shapes, or none at all.
std::optional<Shape> shapeOf(const std::optional<ConvexGeometry>& geometry) noexcept;

struct PlacedElement {
  const Element& element;
  const Pose& world_from_element;
};

/// What a search may use, and what it leaves for the next one.
struct ElementSearch {
  std::uint32_t budget;
  RefineMemory& memory;
  RefineScratch& scratch;
  /// [m] > 0. How far meshes are apart need not be known beyond: a lower bound is then complete.
  double cutoff{std::numeric_limits<double>::infinity()};
  double tolerance{0.0};  ///< [m] as MeshQueryLimits::tolerance
};

/// Signed distance of what two elements are, less their paddings.
///
/// Meshes that overlap are an estimate without depth, or with that of their inner shapes;
/// deepenElements looks for more.
///
/// Convex geometries are measured by signedDistanceBetween, a mesh and whatever it is near by
/// distanceByHulls or, where hulls do not tell, by branch and bound over its triangles. Inner
/// shapes that overlap settle that two meshes do.
ElementDistance measureElements(const PlacedElement& a, const PlacedElement& b,
                                ElementSearch& search) noexcept;

/// [m] A lower bound of the distance of two elements, by what is convex around them;
/// -infinity where that meets. @param search of which `enough` may end it.
double boundByHulls(const PlacedElement& a, const PlacedElement& b, ElementSearch& search) noexcept;

/// What is convex around two elements tells of their distance: exact with points where it is that
/// of the elements, else a lower bound; nothing where it meets. As much as measureElements asks
/// first. @param search of which `enough` may end it.
ElementDistance measureByHulls(const PlacedElement& a, const PlacedElement& b,
                               ElementSearch& search) noexcept;

/// Of two elements known to overlap, a deeper estimate if one is found, by depthOf.
/// @param overlap of quality estimate, changed if it can be bettered.
/// @param most_points as the budget of depthOf, less where the steps left do not suffice.
/// @return steps spent.
std::uint32_t deepenElements(const PlacedElement& a, const PlacedElement& b,
                             std::uint32_t most_points, ElementSearch& search,
                             SignedDistance& overlap) noexcept;

}  // namespace collision_monitor
