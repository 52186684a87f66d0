// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "broad_phase/marked_pairs.h"
#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/pipeline/element.h"
#include "pipeline/data/moved_parts.h"
#include "pipeline/data/placed_links.h"

/// What the cycle keeps of distances, and of how far bodies have moved since.
namespace collision_monitor {

/// How far a body has moved.
struct BodyTravel {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< of the body at DistanceCache::placed
  double all{0.0};  ///< [m] upper bound for any point of the body, since reset to 0
  /// [m] Upper bound for all bodies of its link, between the last two times that travel was added
  /// up; in a continuous set-up also of the way between.
  double of_link{0.0};
  double of_link_all{0.0};  ///< [m] the sum of these since reset to 0
  double ahead{0.0};  ///< [m] upper bound within the horizon; in a continuous set-up also since the
                      ///< last cycle; NaN: not known
  double all_when_listed{0.0};    ///< [m] `all` when DistanceCache::listed was filled
  double ahead_when_listed{0.0};  ///< [m] within the horizon then
};

/// Where that stands which decides whether two elements are near.
struct ElementsPlace {
  BodyId a{};  ///< of the first element, like any other for what all bodies of a link share
  BodyId b{};
  ElementPairIndex elements{};
  std::uint32_t link_pair{0};
  std::uint32_t reach_place{0};  ///< ActivationDistances::place_of its link pair
  std::uint32_t limits{0};       ///< as CheckedLinkPair
};

/// Listed pairs that follow each other: those of two elements, or all lone ones of two links.
struct ListedGroup {
  ElementsPlace place;  ///< of its elements; if it is of lone bodies, of any of them
  bool is_of_lone{false};
  std::uint32_t first{0};  ///< [first, last) of DistanceCache::listed
  std::uint32_t last{0};
  double gap{-std::numeric_limits<double>::infinity()};  ///< [m] at most ListedPair::gap of any
};

/// A pair of bodies that can be near.
struct ListedPair {
  PairId pair{};
  BodyId a{};
  BodyId b{};
  /// [m] A lower bound of their distance when they were last looked at, plus the travel of both
  /// links then: as DistanceCache::elements.
  double gap{-std::numeric_limits<double>::infinity()};
};

/// Bits of DistanceCache::lone.
constexpr unsigned char kLone = 1;       ///< its element has no other body
constexpr unsigned char kOfSeveral = 2;  ///< only beside kLone: its link has other bodies

/// Earlier distances, kept as lower bounds while bodies move.
struct DistanceCache {
  /// By PairId: [m] the last measured distance plus the travel of both bodies at that time. This
  /// value minus their travel now is a lower bound of the distance. -infinity: none.
  std::vector<double> distances;
  std::vector<BodyTravel> travels;  ///< by BodyId
  PlacedLinks placed;               ///< when travel was last added up
  double longest{0.0};              ///< [m] of bodies that moved
  /// By ElementPairIndex: [m] the least distance of its bodies in the last cycle or learnPairs;
  /// infinity if none was measured.
  std::vector<double> nearest;
  std::vector<ElementPairIndex> measured_pairs;  ///< pairs with a finite `nearest`
  /// By LinkPairIndex, of links with lone bodies: [m] an upper bound of the links' distance in the
  /// last cycle. Lone bodies farther apart were not the nearest of their links. Infinity: no bound
  /// is known.
  std::vector<double> nearest_of_links;
  std::vector<std::uint32_t> measured_links;  ///< pairs with a finite `nearest_of_links`
  /// By ElementPairIndex: [m] a lower bound of their distance at some time, plus the travel of both
  /// links then. This value minus their travel now is a lower bound. -infinity: none.
  std::vector<double> elements;
  /// By LinkPairIndex: [m] an upper bound of their distance at some time, minus the travel of both
  /// links then. This value plus their travel now is an upper bound. infinity: none.
  std::vector<double> links;
  /// The pairs that can be near before bodies use up kListMargin, or in this cycle.
  std::vector<ListedPair> listed;
  std::vector<ListedGroup> groups;      ///< of `listed`, in its order
  MarkedPairs marks;                    ///< scratch that sorts pairs; empty between two uses
  std::vector<std::uint32_t> group_of;  ///< by ElementPairIndex: scratch, kNone between two lists
  std::vector<std::uint32_t> group_of_lone;  ///< by LinkPairIndex, as group_of
  std::vector<unsigned char> lone;           ///< by BodyId: kLone, kOfSeveral
  bool has_lone{false};                      ///< a body has both bits
  bool is_listed{false};                     ///< false: `listed` serves this cycle only
  std::vector<IndexRange> listed_moved;      ///< MovedParts::bodies when `listed` was filled
};

}  // namespace collision_monitor
