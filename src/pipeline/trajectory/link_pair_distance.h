// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "motion/conservative_advancement.h"
#include "pipeline/refine/refine_pairs.h"

/// Measures two links in four levels, each costlier and closer than the one before.
namespace collision_monitor {

/// What the levels share; made for one search.
struct LinkPairMeasures {
  explicit LinkPairMeasures(const CycleSetup& setup);

  const CycleSetup& setup;
  std::vector<Ball> balls;  ///< by LinkId
  /// By LinkPairIndex: the first of its pairs in `body_pairs`; at the end, their number.
  std::vector<std::uint32_t> first_body_pair;
  std::vector<PairId> body_pairs;  ///< in order of link pair
  /// By LinkPairIndex: the first of its pairs in CycleSetup::element_pairs; at the end, their
  /// number.
  std::vector<ElementPairIndex> first_element_pair;
  /// By LinkPairIndex: whether an element has a mesh that differs from its hull.
  std::vector<unsigned char> has_meshes;
  RefineStore memory;
  std::vector<PairDistance> nearest_bodies;  ///< of each element pair of the current link pair
  std::unique_ptr<RefineScratch> scratch;
  double leeway{0.0};   ///< [m] of the last elementDistance: least distance minus contact distance
  double outside{0.0};  ///< [m] of the last elementDistance: MeshDistance::outside
  std::uint64_t work{0};  ///< as in RefineLimits::budget; a pair of bodies counts one
};

/// Whether elements are measured before bodies: each link has one, which is its geometry. Bodies,
/// of which there may be many, take several times as long as hulls that are apart, and tell no
/// more.
bool asksElementsFirst(const LinkPairMeasures& measures, LinkPairIndex pair) noexcept;

/// The distance of the enclosing shapes.
PairDistance bodyDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link) noexcept;

/// Measures the bodies of each pair of elements of a pair of links into `nearest_bodies`.
void measureBodies(LinkPairMeasures& measures, LinkPairIndex pair,
                   const std::vector<Pose>& world_from_link) noexcept;

/// The distance of two elements, or that of their bodies if that is the better bound. Lessens
/// LinkPairMeasures::outside to what was met.
/// @param bodies from measureBodies
/// @param cutoff [m] > 0, as in elementDistance
PairDistance elementPairDistance(LinkPairMeasures& measures, ElementPairIndex pair,
                                 const PairDistance& bodies,
                                 const std::vector<Pose>& world_from_link, double cutoff) noexcept;

/// The distance of the hulls of elements: a lower bound, mostly close, for a hundredth of the work
/// of meshes. Refined if it is the distance of the elements. For depths it is that of the enclosing
/// shapes.
/// @param cutoff [m] > 0: a larger distance need not be known.
PairDistance hullDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link, double cutoff) noexcept;

/// The distance of the elements.
/// @param cutoff [m] > 0: a larger distance need not be known, which makes meshes that are apart
/// ten times faster or more.
PairDistance elementDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                             const std::vector<Pose>& world_from_link,
                             double cutoff = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace collision_monitor
