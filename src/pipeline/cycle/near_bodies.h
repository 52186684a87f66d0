// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/data/activation_distance.h"

namespace collision_monitor {

/// How near bodies must be to matter, one pair after the other.
struct NearBodies {
  const CycleSetup& setup;
  const ActivationDistances& reaches;
  const DistanceCache& cache;
  double least;  ///< [m] as nearActivationDistanceOf
  double reach;  ///< [m] as reachOf

  /// [m] No farther apart, bodies matter whatever other bodies of their elements do: by what both
  /// links may close, or by what both bodies may.
  double nearOf(PairId id) const noexcept {
    const BodyPair& pair = setup.table[id];
    const double ahead = cache.travels[index(pair.a)].ahead + cache.travels[index(pair.b)].ahead;
    // What is not known is NaN, which both comparisons are asked so as to pass over.
    return std::min(reaches.near_of_pair[setup.link_pair_of[index(id)]],
                    std::max(reaches.stop + ahead, least));
  }

  /// [m] Farther apart, bodies do not matter: those of their elements that are `nearest` do.
  double limitOf(PairId id, double nearest) const noexcept {
    return std::max(nearOf(id), std::min(reach, nearest));
  }
};

inline NearBodies nearBodies(const CycleSetup& setup, const CycleBuffers& buffers) noexcept {
  return {setup, buffers.activation, buffers.memory.distance_cache, nearActivationDistanceOf(setup),
          activationDistanceOf(setup.limits)};
}

/// Remembers a lower bound of the distance.
inline void rememberDistance(double distance, const BodyPair& pair, PairId id,
                             DistanceCache& cache) noexcept {
  cache.distances[index(id)] =
      distance + (cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all);
}

}  // namespace collision_monitor
