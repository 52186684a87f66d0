// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// How near the bodies of a pair must be to matter.
struct NearBodies {
  const CycleSetup& setup;
  const ActivationDistances& reaches;
  const DistanceCache& cache;
  const std::vector<double>& told_below;  ///< as RefineWork
  const std::vector<Verdict>& reported;   ///< as PairMemory

  /// What is looked up of a pair, gathered.
  ElementsPlace placeOf(PairId id) const noexcept {
    const std::uint32_t link_pair = setup.link_pair_of[index(id)];
    return {setup.table[id].a,
            setup.table[id].b,
            setup.element_pair_of[index(id)],
            link_pair,
            reaches.place_of[link_pair],
            setup.own_limits.empty() ? 0 : setup.checked[link_pair].limits};
  }

  /// [m] At or below this distance bodies matter whatever other bodies of their elements do. It is
  /// the lesser of two bounds: by the motion of both links, and by the motion of both bodies.
  double nearOf(const ElementsPlace& pair) const noexcept {
    const PairReach& reach = reaches.of_limits[pair.limits];
    return nearOf({byLinks(pair), reach.near, reach.stop}, pair.a, pair.b);
  }

  /// The two bounds: by links, and at rest or from a stop on.
  struct Bounds {
    double by_links;
    double at_rest;
    double stop;
  };
  double nearOf(const Bounds& bounds, BodyId a, BodyId b) const noexcept {
    const double ahead = cache.travels[index(a)].ahead + cache.travels[index(b)].ahead;
    // `ahead` may be NaN: by the order of arguments the result is then the other bound.
    return std::min(bounds.by_links, std::max(bounds.stop + ahead, bounds.at_rest));
  }

  /// [m] As nearOf, for any bodies of these links.
  double byLinks(const ElementsPlace& pair) const noexcept {
    return std::max(reaches.of_limits[pair.limits].near, reaches.motion[pair.reach_place]);
  }

  /// [m] At or below this distance somebody may be told how near the links are: up to all that is
  /// reported where a warning or contact may end.
  double heardOf(const ElementsPlace& pair) const noexcept {
    const bool is_clear = reported[pair.link_pair] == Verdict::clear;
    return is_clear ? toldOf(pair) : reaches.of_limits[pair.limits].all;
  }

  /// [m] As heardOf, of pairs whose verdict does not change.
  double toldOf(const ElementsPlace& pair) const noexcept {
    const double told = std::max(reaches.told[pair.reach_place], told_below[pair.link_pair]);
    return std::min(reaches.of_limits[pair.limits].all, told);
  }

  /// [m] limitOf is not above this for bodies with these travels, whatever pair they are. NaN if a
  /// motion ahead is unknown.
  double highestLimitOf(const BodyTravel& a, const BodyTravel& b) const noexcept {
    const PairReach& farthest = reaches.farthest;
    return std::max(farthest.stop + (a.ahead + b.ahead), std::max(farthest.all, farthest.near));
  }

  /// [m] Above this distance bodies do not matter, since nearer ones of their elements do.
  double limitOf(const ElementsPlace& pair, double nearest) const noexcept {
    return std::max(nearOf(pair), std::min(heardOf(pair), nearest));
  }
};

inline NearBodies nearBodies(const CycleSetup& setup, const CycleBuffers& buffers) noexcept {
  return {setup, buffers.activation, buffers.memory.distance_cache, buffers.refine.told_below,
          buffers.memory.reported};
}

/// [m] How far the links of two bodies have moved.
/// @param pair an ElementsPlace or a BodyPair
template <class Pair>
double travelOfLinks(const DistanceCache& cache, const Pair& pair) noexcept {
  return cache.travels[index(pair.a)].of_link_all + cache.travels[index(pair.b)].of_link_all;
}

/// Stores a lower bound of the distance in the cache.
inline void rememberDistance(double distance, const BodyPair& pair, PairId id,
                             DistanceCache& cache) noexcept {
  cache.distances[index(id)] =
      distance + (cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all);
}

}  // namespace collision_monitor
