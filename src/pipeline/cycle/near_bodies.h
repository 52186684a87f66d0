// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/data/activation_distance.h"

namespace collision_monitor {

/// How near the bodies of a pair must be to matter.
struct NearBodies {
  const CycleSetup& setup;
  const ActivationDistances& reaches;
  const DistanceCache& cache;
  double least;  ///< [m] as nearActivationDistanceOf
  double reach;  ///< [m] as activationDistanceOf

  /// [m] At or below this distance bodies matter whatever other bodies of their elements do. It is
  /// the lesser of two bounds: by the motion of both links, and by the motion of both bodies.
  double nearOf(PairId id) const noexcept {
    const BodyPair& pair = setup.table[id];
    const double ahead = cache.travels[index(pair.a)].ahead + cache.travels[index(pair.b)].ahead;
    // `ahead` may be NaN: by the order of arguments the result is then the other bound.
    return std::min(reaches.near_of_pair[setup.link_pair_of[index(id)]],
                    std::max(reaches.stop + ahead, least));
  }

  /// [m] Above this distance bodies do not matter, since nearer ones of their elements do.
  double limitOf(PairId id, double nearest) const noexcept {
    return std::max(nearOf(id), std::min(reach, nearest));
  }
};

inline NearBodies nearBodies(const CycleSetup& setup, const CycleBuffers& buffers) noexcept {
  return {setup, buffers.activation, buffers.memory.distance_cache, nearActivationDistanceOf(setup),
          activationDistanceOf(setup.limits)};
}

/// Stores a lower bound of the distance in the cache.
inline void rememberDistance(double distance, const BodyPair& pair, PairId id,
                             DistanceCache& cache) noexcept {
  cache.distances[index(id)] =
      distance + (cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all);
}

}  // namespace collision_monitor
