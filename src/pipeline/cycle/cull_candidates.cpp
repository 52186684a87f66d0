// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/cull_candidates.h"

#include <algorithm>
#include <utility>

#include "geometry/constants.h"
#include "narrow_phase/sat/separating_axes.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/near_bodies.h"
#include "pipeline/cycle/settled_pairs.h"

namespace collision_monitor {
namespace {

/// Avoids a square root.
/// @param distance [m] pairs at or below it are kept
bool ballsPart(const Ball& a, const Ball& b, double distance) noexcept {
  constexpr double kRounding = 1e-12;
  const double reach = a.radius + b.radius + distance;
  const double squared_distance = (b.center - a.center).squaredNorm();
  return (reach < 0.0) | (squared_distance > reach * reach * (1.0 + kRounding));
}

bool orientedBoxesPart(const CycleSetup& setup, const BodyPoses& poses, const BodyPair& pair,
                       double distance) noexcept {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  const BoxPair boxes = makeBoxPair(setup.cores[a].half_extents, poses.world_from_body[a],
                                    setup.cores[b].half_extents, poses.world_from_body[b]);
  const double gap =
      separationsOfBoxes(boxes).largest - setup.cores[a].radius - setup.cores[b].radius;
  return gap > distance + toleranceOf(boxes);
}

/// Has no branch of its own, since which candidates are far is hard to predict.
template <class IsFar>
void keepUnless(const IsFar& is_far, std::vector<PairId>& candidates) noexcept {
  std::size_t kept = 0;
  for (const PairId id : candidates) {
    candidates[kept] = id;
    kept += is_far(id) ? 0 : 1;
  }
  candidates.resize(kept);
}

/// Looks up what decides for all bodies of two elements.
void lookUp(const NearBodies& near, const RefineWork& refined, ListedElements& elements) noexcept {
  const ElementsPlace& place = elements.place;
  const PairReach& reach = near.reaches.of_limits[place.limits];
  const std::vector<BodyTravel>& travels = near.cache.travels;
  const double step = travels[index(place.a)].of_link + travels[index(place.b)].of_link;
  elements.by_links = near.byLinks(place);
  elements.at_rest = reach.near;
  elements.stop = reach.stop;
  elements.nearest = near.cache.nearest[place.elements] + step;
  elements.told = std::min(near.heardOf(place), elements.nearest);
  elements.is_measured = refined.is_measured[place.elements] != 0;
  elements.least_gap = kInfinity;
  elements.has_near = false;
}

/// Passes over elements that are far or settled with all of their bodies.
void passElements(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  const NearBodies near = nearBodies(setup, buffers);
  SettledPairs settled(setup, near, buffers);
  for (ListedElements& elements : cache.listed_elements) {
    const ElementsPlace& place = elements.place;
    elements.travel = travelOfLinks(cache, place);
    const bool is_far =
        elements.gap - elements.travel > std::max(near.byLinks(place), near.heardOf(place));
    elements.is_passed = is_far || settled.passOver(place);
    if (!elements.is_passed) {
      lookUp(near, buffers.refine, elements);
    }
  }
}

/// Keeps how far elements are whose bodies are all far.
void keepGaps(DistanceCache& cache) noexcept {
  for (ListedElements& elements : cache.listed_elements) {
    if (!elements.is_passed && !elements.has_near) {
      elements.gap = elements.least_gap + elements.travel;
    }
  }
}

/// Takes from the list what the distance cache does not prove to be far. Of elements refined in the
/// last cycle, which are most likely refined again, it defers all bodies but the nearest. Has no
/// branch for a body, as keepUnless.
void cullByCache(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  constexpr double kRounding = 1e-9;  // of the cached distance and of a new one
  DistanceCache& cache = buffers.memory.distance_cache;
  const NearBodies near = nearBodies(setup, buffers);
  passElements(setup, buffers);
  buffers.candidates.resize(cache.listed.size());
  buffers.deferred.resize(cache.listed.size());
  std::size_t kept = 0;
  std::size_t deferred = 0;
  for (const ListedPair& pair : cache.listed) {
    ListedElements& of = cache.listed_elements[pair.place];
    if (of.is_passed) {
      continue;
    }
    const double travel = cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all;
    const double gap = cache.distances[index(pair.pair)] - travel - kRounding;
    const double limit =
        std::max(near.nearOf({of.by_links, of.at_rest, of.stop}, pair.a, pair.b), of.told);
    const bool is_near = !(gap > limit);
    const bool waits = is_near & (gap > of.nearest) & of.is_measured;
    of.least_gap = std::min(of.least_gap, gap);
    of.has_near |= is_near;
    buffers.candidates[kept] = buffers.deferred[deferred] = pair.pair;
    kept += (is_near & !waits) ? 1 : 0;
    deferred += waits ? 1 : 0;
  }
  buffers.candidates.resize(kept);
  buffers.deferred.resize(deferred);
  keepGaps(cache);
}

void cullBySpheres(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const std::vector<Ball>& balls = buffers.body_poses.balls;
  const NearBodies near = nearBodies(setup, buffers);
  const auto isFar = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    const Ball& a = balls[index(pair.a)];
    const Ball& b = balls[index(pair.b)];
    if (!ballsPart(a, b, near.limitOf(near.placeOf(id), kInfinity))) {
      return false;
    }
    const double gap = (b.center - a.center).norm() - a.radius - b.radius;
    rememberDistance(gap, pair, id, buffers.memory.distance_cache);
    return true;
  };
  keepUnless(isFar, buffers.candidates);
}

void cullByBoxes(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const NearBodies near = nearBodies(setup, buffers);
  const auto isFar = [&](PairId id) {
    return orientedBoxesPart(setup, buffers.body_poses, setup.table[id],
                             near.limitOf(near.placeOf(id), kInfinity));
  };
  keepUnless(isFar, buffers.candidates);
}

}  // namespace

void cullCandidates(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  CycleCounters& counters = buffers.counters;
  std::size_t left = counters.candidates;
  const auto countCulled = [&] {
    const std::size_t before = std::exchange(left, buffers.candidates.size());
    return before - left;
  };
  cullByCache(setup, buffers);
  counters.culled_by_cache = countCulled();
  cullBySpheres(setup, buffers);
  counters.culled_by_spheres = countCulled();
  if (buffers.culls_by_boxes) {
    cullByBoxes(setup, buffers);
  }
  counters.culled_by_boxes = countCulled();
  constexpr std::size_t kPassed = 8;  // candidates are passed over in the time of a measurement
  buffers.refine.near_bodies = buffers.candidates.size() + counters.candidates / kPassed;
}

}  // namespace collision_monitor
