// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// The shape of a geometry; nothing for geometries that are no Shape, and for none.
std::optional<Shape> shapeOf(const std::optional<ConvexGeometry>& geometry) noexcept;

struct PlacedElement {
  const Element& element;
  const Pose& world_from_element;
};

/// What a search may use, and what it keeps for the next search.
struct ElementSearch {
  std::uint32_t budget;
  RefineMemory& memory;
  RefineScratch& scratch;
  /// [m] > 0. A lower bound at or above the cutoff is a complete answer.
  double cutoff{std::numeric_limits<double>::infinity()};
  double tolerance{0.0};  ///< [m] as MeshQueryLimits::tolerance
  /// No later search starts from the answer, and only the distance matters: there is no
  /// ElementDistance::outside, and no distance of convex geometries beyond the cutoff. See
  /// ConvexSearch::stands_alone.
  bool stands_alone{false};
};

/// Measures the signed distance of two elements, paddings included.
///
/// Overlapping meshes give an estimate of depth 0 or of the depth of their inner shapes;
/// deepenElements searches for a larger depth.
///
/// Convex geometries are measured by signedDistanceBetween. Meshes are measured by distanceByHulls
/// or, where hulls give no answer, by branch and bound over triangles. Overlapping inner shapes
/// prove that two meshes overlap.
ElementDistance measureElements(const PlacedElement& a, const PlacedElement& b,
                                ElementSearch& search) noexcept;

/// Measures two elements by their hulls, as measureElements does first: exact with points where
/// hulls give the distance of the elements, else a lower bound; nothing if hulls touch.
/// @param search its `cutoff` may end the search.
ElementDistance measureByHulls(const PlacedElement& a, const PlacedElement& b,
                               ElementSearch& search) noexcept;

/// Searches for a larger depth of two overlapping elements, by depthOf.
/// @param overlap of quality estimate; replaced if a larger depth is found.
/// @param most_points as the budget of depthOf; reduced to what the work left allows.
/// @return work done.
std::uint32_t deepenElements(const PlacedElement& a, const PlacedElement& b,
                             std::uint32_t most_points, ElementSearch& search,
                             SignedDistance& overlap) noexcept;

}  // namespace collision_monitor
