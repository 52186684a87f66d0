// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "motion/conservative_advancement.h"
#include "pipeline/refine/refine_pairs.h"

/// The distance of two links, in four steps that cost more and say more.
namespace collision_monitor {

/// What the steps share; made for one search.
struct LinkPairMeasures {
  explicit LinkPairMeasures(const CycleSetup& setup);

  const CycleSetup& setup;
  std::vector<Ball> balls;  ///< by LinkId
  /// By LinkPairIndex: where its pairs start in `body_pairs`, and behind the last their end.
  std::vector<std::uint32_t> first_body_pair;
  std::vector<PairId> body_pairs;  ///< in order of their pairs of links
  /// By LinkPairIndex: where its pairs start in CycleSetup::element_pairs, and behind the last
  /// their end.
  std::vector<ElementPairIndex> first_element_pair;
  /// By LinkPairIndex: whether some elements have a mesh that is not what is convex around it.
  std::vector<unsigned char> has_meshes;
  RefineStore memory;
  std::vector<PairDistance> nearest_bodies;  ///< of each element pair of the pair of links at hand
  std::unique_ptr<RefineScratch> scratch;
  double leeway{0.0};     ///< [m] of elementDistance: how far its elements are from contact
  double outside{0.0};    ///< [m] of elementDistance: as MeshDistance::outside
  std::uint64_t work{0};  ///< as RefineLimits::budget counts them; a pair of bodies is one
};

/// [m] A lower bound, by one ball a link.
double ballDistance(const LinkPairMeasures& measures, LinkPairIndex pair,
                    const std::vector<Pose>& world_from_link) noexcept;

/// Of the enclosing shapes.
PairDistance bodyDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link) noexcept;

/// Of what is convex around the elements: a lower bound of their distance, at a hundredth of the
/// cost of meshes and mostly near it. Where it is their distance, it is refined.
/// Of depths it is that of the enclosing shapes.
/// @param enough [m] > 0: of what is farther apart, no more need be known than that.
PairDistance hullDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                          const std::vector<Pose>& world_from_link, double cutoff) noexcept;

/// Of the elements.
/// @param enough [m] > 0: of what is farther apart, no more need be known than that. Meshes apart
/// take a tenth of the time then, or less.
PairDistance elementDistance(LinkPairMeasures& measures, LinkPairIndex pair,
                             const std::vector<Pose>& world_from_link,
                             double cutoff = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace collision_monitor
