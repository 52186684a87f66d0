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

/// [m] A lower bound of the distance, by oriented boxes.
double gapOfBoxes(const CycleSetup& setup, const BodyPoses& poses, const BodyPair& pair) noexcept {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  const BoxPair boxes = makeBoxPair(setup.cores[a].half_extents, poses.world_from_body[a],
                                    setup.cores[b].half_extents, poses.world_from_body[b]);
  const double gap =
      separationsOfBoxes(boxes).largest - setup.cores[a].radius - setup.cores[b].radius;
  return gap - toleranceOf(boxes);
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

/// Looks up what decides for all bodies of a group.
void lookUp(const NearBodies& near, const RefineWork& refined, ListedGroup& group) noexcept {
  const ElementsPlace& place = group.place;
  const PairReach& reach = near.reaches.of_limits[place.limits];
  const double step = stepOfLinks(near.cache, place);
  group.by_links = near.byLinks(place);
  group.at_rest = reach.near;
  group.stop = reach.stop;
  group.nearest = group.is_of_lone ? kInfinity : near.cache.nearest[place.elements] + step;
  group.told = near.seeksAmong(place.link_pair)
                   ? std::max(reach.near, std::min(reach.all, group.nearest))
                   : near.atRest(place, group.nearest);
  group.is_measured = refined.is_measured[place.elements] != 0;
  group.least_gap = kInfinity;
  group.has_near = false;
}

/// Passes over groups that are far or settled with all of their bodies.
void passGroups(const NearBodies& near, SettledPairs& settled, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  for (ListedGroup& group : cache.groups) {
    const ElementsPlace& place = group.place;
    group.travel = travelOfLinks(cache, place);
    const double told = near.seeksAmong(place.link_pair) ? near.reaches.of_limits[place.limits].all
                                                         : near.heardOf(place);
    const bool is_far = group.gap - group.travel > std::max(near.byLinks(place), told);
    group.is_passed = is_far || (!group.is_of_lone && settled.passOver(place));
    if (!group.is_passed) {
      lookUp(near, buffers.refine, group);
    }
  }
}

/// Keeps how far groups are whose bodies are all far.
void keepGaps(DistanceCache& cache) noexcept {
  for (ListedGroup& group : cache.groups) {
    if (!group.is_passed && !group.has_near) {
      group.gap = group.least_gap + group.travel;
    }
  }
}

/// Takes from the list what the distance cache does not prove to be far. Of elements refined in the
/// last cycle, which are most likely refined again, it defers all bodies but the nearest. Has no
/// branch for a body, as keepUnless.
void cullByCache(const NearBodies& near, SettledPairs& settled, CycleBuffers& buffers) noexcept {
  constexpr double kRounding = 1e-9;  // of the cached distance and of a new one
  DistanceCache& cache = buffers.memory.distance_cache;
  passGroups(near, settled, buffers);
  buffers.candidates.resize(cache.listed.size());
  buffers.deferred.resize(cache.listed.size());
  std::size_t kept = 0;
  std::size_t deferred = 0;
  for (const ListedPair& pair : cache.listed) {
    ListedGroup& of = cache.groups[pair.place];
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

/// [m] Improves the cached lower bound of a distance by the bodies' spheres. @return the bound
double improveBySpheres(const NearBodies& near, const ElementsPlace& pair,
                        double& cached) noexcept {
  constexpr double kRounding = 1e-9;  // of both distances and of a new one
  const std::vector<BodyTravel>& travels = near.cache.travels;
  const Ball& a = near.balls[index(pair.a)];
  const Ball& b = near.balls[index(pair.b)];
  const double travel = travels[index(pair.a)].all + travels[index(pair.b)].all;
  cached = std::max(cached, (b.center - a.center).norm() - a.radius - b.radius + travel);
  return cached - travel - kRounding;
}

/// Decides for lone bodies. What holds for all bodies of two links is looked up once in a row.
class LoneBodies {
 public:
  LoneBodies(const NearBodies& near, CycleBuffers& buffers) noexcept
      : near_(near),
        distances_(buffers.memory.distance_cache.distances),
        deferred_(buffers.deferred) {}

  /// By spheres, and by how fast bodies close. Defers those that matter only if they are the
  /// nearest of their links, where others were nearer. @pre cullByCache left them
  bool isFar(PairId id, const ElementsPlace& place) noexcept {
    if (place.link_pair != links_) {
      lookUp(place);
    }
    const double gap = improveBySpheres(near_, place, distances_[index(id)]);
    const bool is_heard = !(gap > heard_);
    const bool is_far = gap > at_rest_ && ((is_heard && gap > near_.nearOf(place)) ||
                                           gap > near_.byClosing(place, closing_));
    if (is_far && is_heard) {
      deferred_.push_back(id);
    }
    return is_far;
  }

 private:
  void lookUp(const ElementsPlace& place) noexcept {
    links_ = place.link_pair;
    closing_ = near_.closingOf(place);
    heard_ = near_.atRest(place, kInfinity);
    at_rest_ = near_.atRest(place, near_.nearestOfLone(place) + stepOfLinks(near_.cache, place));
  }

  const NearBodies& near_;
  std::vector<double>& distances_;
  std::vector<PairId>& deferred_;
  LinkPairIndex links_{kNone};
  NearBodies::Closing closing_{};
  double heard_{0.0};    ///< [m] up to this, bodies matter to somebody who listens
  double at_rest_{0.0};  ///< [m] as NearBodies::atRest
};

void cullBySpheres(const CycleSetup& setup, const NearBodies& near,
                   CycleBuffers& buffers) noexcept {
  LoneBodies lone(near, buffers);
  const auto isFar = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    const ElementsPlace place = near.placeOf(id);
    if (near.passesLone(place)) {
      return lone.isFar(id, place);
    }
    const double limit = std::max(near.nearOf(place), near.atRest(place, kInfinity));
    if (!ballsPart(near.balls[index(pair.a)], near.balls[index(pair.b)], limit)) {
      return false;
    }
    improveBySpheres(near, place, buffers.memory.distance_cache.distances[index(id)]);
    return true;
  };
  keepUnless(isFar, buffers.candidates);
}

void cullByBoxes(const CycleSetup& setup, const NearBodies& near, CycleBuffers& buffers) noexcept {
  const auto isFar = [&](PairId id) {
    const double gap = gapOfBoxes(setup, buffers.body_poses, setup.table[id]);
    return near.isFar(near.placeOf(id), kInfinity, gap);
  };
  keepUnless(isFar, buffers.candidates);
}

/// Decides which lone bodies are passed over by how they close. A scale that jumps to 1 takes that
/// none closes, and none rests near.
void passLone(CycleBuffers& buffers) noexcept {
  RobotSpeeds& robots = buffers.robots;
  robots.passes_lone = buffers.memory.distance_cache.has_lone;
  robots.seeks_closing = std::find(robots.may_be_free.begin(), robots.may_be_free.end(), 1) !=
                         robots.may_be_free.end();
}

/// Passes over lone bodies of elements that are settled.
void cullSettled(const CycleSetup& setup, const NearBodies& near, SettledPairs& settled,
                 std::vector<PairId>& candidates) noexcept {
  const auto isSettled = [&](PairId id) {
    return areLone(near.cache, setup.table[id]) && settled.passOver(near.placeOf(id));
  };
  keepUnless(isSettled, candidates);
}

}  // namespace

void cullCandidates(const CycleSetup& setup, const LinkPoses& poses,
                    CycleBuffers& buffers) noexcept {
  CycleCounters& counters = buffers.counters;
  passLone(buffers);
  const NearBodies near = nearBodies(setup, poses, buffers);
  SettledPairs settled(setup, near, buffers);
  std::size_t left = counters.candidates;
  const auto countCulled = [&] {
    const std::size_t before = std::exchange(left, buffers.candidates.size());
    return before - left;
  };
  cullByCache(near, settled, buffers);
  counters.culled_by_cache = countCulled();
  const std::size_t deferred = buffers.deferred.size();
  cullBySpheres(setup, near, buffers);
  const std::size_t deferred_more = buffers.deferred.size() - deferred;
  counters.culled_by_cache += deferred_more;
  counters.culled_by_spheres = countCulled() - deferred_more;
  if (buffers.culls_by_boxes) {
    cullByBoxes(setup, near, buffers);
  }
  counters.culled_by_boxes = countCulled();
  cullSettled(setup, near, settled, buffers.candidates);
  counters.culled_by_cache += countCulled();
  constexpr std::size_t kPassed = 8;  // candidates are passed over in the time of a measurement
  buffers.refine.near_bodies = buffers.candidates.size() + counters.candidates / kPassed;
}

}  // namespace collision_monitor
