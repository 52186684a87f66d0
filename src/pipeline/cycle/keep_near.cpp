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
void keepNearFrom(const CycleSetup& setup, const LinkPoses& poses, std::size_t first,
                  CycleBuffers& buffers) noexcept {
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
  const NearBodies near = nearBodies(setup, poses, buffers);
  const auto is_far = [&](const PairDistance& distance) {
    const ElementsPlace pair = near.placeOf(distance.pair);
    return near.isFar(pair, cache.nearest[pair.elements], distance.measured.distance);
  };
  measured.erase(std::remove_if(begin, measured.end(), is_far), measured.end());
}

/// Whether its elements were near enough to be refined.
bool isTask(const CycleSetup& setup, const RefineWork& refined, const PairDistance& pair) noexcept {
  return refined.task_of[setup.element_pair_of[index(pair.pair)]] != kNone;
}

/// Finds the nearest lone bodies of each two links, among the distances from index `first` on.
/// Where elements are refined, the least refined distance counts: those that were starved or
/// skipped have only a lower bound.
void findNearestOfLinks(const CycleSetup& setup, std::size_t first,
                        CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  for (std::size_t i = first; i < buffers.distances.pairs.size(); ++i) {
    const PairDistance& pair = buffers.distances.pairs[i];
    if (!areLone(cache, setup.table[pair.pair])) {
      continue;
    }
    const LinkPairIndex links = setup.link_pair_of[index(pair.pair)];
    const double value = isTask(setup, buffers.refine, pair) ? buffers.refine.nearest[links]
                                                             : pair.measured.distance;
    double& nearest = cache.nearest_of_links[links];
    if (value < nearest) {
      if (nearest == kInfinity) {
        cache.measured_links.push_back(links);
      }
      nearest = value;
    }
  }
}

/// Drops what need not be measured of the deferred pairs.
void dropDecided(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  constexpr double kRounding = 1e-9;
  const DistanceCache& cache = buffers.memory.distance_cache;
  const NearBodies near = nearBodies(setup, poses, buffers);
  const auto isDecided = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    const ElementsPlace place = near.placeOf(id);
    const double travel = cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all;
    return buffers.refine.is_measured[place.elements] != 0 ||
           near.isFar(place, near.nearestOfLone(place),
                      cache.distances[index(id)] - travel - kRounding);
  };
  auto& deferred = buffers.deferred;
  deferred.erase(std::remove_if(deferred.begin(), deferred.end(), isDecided), deferred.end());
  std::sort(deferred.begin(), deferred.end());
}

/// Drops lone bodies that matter only if they are the nearest of their links, and are not.
void dropFarther(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  const NearBodies near = nearBodies(setup, poses, buffers);
  const auto isFarther = [&](const PairDistance& pair) {
    const ElementsPlace place = near.placeOf(pair.pair);
    const std::uint32_t task = buffers.refine.task_of[place.elements];
    // A refined pair may also have come out of an open mesh.
    const double outside = task == kNone ? kInfinity : buffers.refine.tasks[task].outside;
    const double distance = pair.measured.distance;
    return distance > near.nearestOfLone(place) && !near.closes(place, std::min(distance, outside));
  };
  auto& measured = buffers.distances.pairs;
  measured.erase(std::remove_if(measured.begin(), measured.end(), isFarther), measured.end());
}

/// Sorts distances by pair. Those before index `first` are sorted; mostly few follow, or none.
void sortFrom(std::size_t first, std::vector<PairDistance>& distances) noexcept {
  constexpr std::size_t kFew = 16;
  const auto comesFirst = [](const PairDistance& x, const PairDistance& y) {
    return x.pair < y.pair;
  };
  if (distances.size() - first > kFew) {
    std::sort(distances.begin(), distances.end(), comesFirst);
    return;
  }
  for (auto next = distances.begin() + static_cast<std::ptrdiff_t>(first); next != distances.end();
       ++next) {
    std::rotate(std::upper_bound(distances.begin(), next, *next, comesFirst), next, next + 1);
  }
}

}  // namespace

void keepNear(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  forgetNearest(buffers.memory.distance_cache);
  keepNearFrom(setup, poses, 0, buffers);
}

void measureDeferred(const CycleSetup& setup, const LinkPoses& poses,
                     CycleBuffers& buffers) noexcept {
  if (!buffers.robots.passes_lone && buffers.deferred.empty()) {
    return;
  }
  forgetNearestOfLinks(buffers.memory.distance_cache);
  findNearestOfLinks(setup, 0, buffers);
  dropDecided(setup, poses, buffers);
  auto& measured = buffers.distances.pairs;
  const std::size_t first = measured.size();
  if (!buffers.deferred.empty()) {
    addPairs(setup, buffers.body_poses, buffers.deferred, buffers.distances);
    keepNearFrom(setup, poses, first, buffers);
    findNearestOfLinks(setup, first, buffers);
    sortFrom(first, measured);
    buffers.counters.culled_by_cache -= buffers.deferred.size();
  }
  dropFarther(setup, poses, buffers);
}

}  // namespace collision_monitor
