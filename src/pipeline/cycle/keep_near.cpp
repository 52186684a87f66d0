// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/keep_near.h"

#include <algorithm>

#include "geometry/constants.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/near_bodies.h"

namespace collision_monitor {
namespace {

/// For distances from index `first` on.
void keepNearFrom(const CycleSetup& setup, std::size_t first, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  auto& measured = buffers.distances.pairs;
  const auto begin = measured.begin() + static_cast<std::ptrdiff_t>(first);
  std::for_each(begin, measured.end(), [&](const PairDistance& distance) {
    const double value = distance.measured.distance;
    rememberDistance(value, setup.table[distance.pair], distance.pair, cache);
    const ElementPairIndex pair = setup.element_pair_of[index(distance.pair)];
    if (value < cache.nearest[pair]) {
      if (cache.nearest[pair] == kInfinity) {
        cache.measured_pairs.push_back(pair);
      }
      cache.nearest[pair] = value;
    }
  });
  const NearBodies near = nearBodies(setup, buffers);
  const auto is_far = [&](const PairDistance& distance) {
    const ElementsPlace pair = near.placeOf(distance.pair);
    return distance.measured.distance > near.limitOf(pair, cache.nearest[pair.elements]);
  };
  measured.erase(std::remove_if(begin, measured.end(), is_far), measured.end());
}

}  // namespace

void keepNear(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  forgetNearest(buffers.memory.distance_cache);
  keepNearFrom(setup, 0, buffers);
}

void measureDeferred(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const auto isRefined = [&](PairId id) {
    return buffers.refine.is_measured[setup.element_pair_of[index(id)]] != 0;
  };
  auto& deferred = buffers.deferred;
  deferred.erase(std::remove_if(deferred.begin(), deferred.end(), isRefined), deferred.end());
  if (deferred.empty()) {
    return;
  }
  auto& measured = buffers.distances.pairs;
  const std::size_t first = measured.size();
  addPairs(setup, buffers.body_poses, deferred, buffers.distances);
  keepNearFrom(setup, first, buffers);
  std::sort(measured.begin(), measured.end(),
            [](const PairDistance& x, const PairDistance& y) { return x.pair < y.pair; });
  buffers.counters.culled_by_cache -= deferred.size();
}

}  // namespace collision_monitor
