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

/// What decides for all bodies of a group.
struct GroupLimits {
  NearBodies::Bounds near;
  double nearest;    ///< [m] bodies farther than this are not the nearest of two elements
  double told;       ///< [m] up to this distance the nearest bodies matter
  bool is_measured;  ///< in the last cycle
};

GroupLimits limitsOf(const NearBodies& near, const RefineWork& refined,
                     const ListedGroup& group) noexcept {
  const ElementsPlace& place = group.place;
  const PairReach& reach = near.reaches.of_limits[place.limits];
  const double nearest = group.is_of_lone
                             ? kInfinity
                             : near.cache.nearest[place.elements] + stepOfLinks(near.cache, place);
  const double told = near.seeksAmong(place.link_pair)
                          ? std::max(reach.near, std::min(reach.all, nearest))
                          : near.atRest(place, nearest);
  return {{near.byLinks(place), reach.near, reach.stop},
          nearest,
          told,
          refined.is_measured[place.elements] != 0};
}

/// Whether the bodies of a group are all proven to be far.
bool isGroupFar(const NearBodies& near, const ListedGroup& group) noexcept {
  const ElementsPlace& place = group.place;
  const double told = near.seeksAmong(place.link_pair) ? near.reaches.of_limits[place.limits].all
                                                       : near.heardOf(place);
  const double gap = group.gap - travelOfLinks(near.cache, place);
  return gap > std::max(near.byLinks(place), told);
}

/// Where the next pair is written.
struct KeptPairs {
  PairId* candidate;
  PairId* deferred;
};

/// Keeps the bodies of a group that the distance cache does not prove to be far. Of elements
/// refined in the last cycle, which are most likely refined again, it defers all bodies but the
/// nearest. @return [m] the least of ListedPair::gap
double keepNear(const NearBodies& near, const GroupLimits& limits, const ListedGroup& group,
                std::vector<ListedPair>& listed, KeptPairs& kept) noexcept {
  constexpr double kRounding = 1e-9;  // of the cached distance and of a new one
  const DistanceCache& cache = near.cache;
  const double travel_of_links = travelOfLinks(cache, group.place);
  const double far = std::max(limits.near.by_links, limits.told) + travel_of_links;
  double least = kInfinity;
  for (std::uint32_t i = group.first; i < group.last; ++i) {
    ListedPair& pair = listed[i];
    if (!(pair.gap > far)) {
      const double travel = cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all;
      const double gap = cache.distances[index(pair.pair)] - travel - kRounding;
      const bool is_near = !(gap > std::max(near.nearOf(limits.near, pair.a, pair.b), limits.told));
      const bool waits = is_near & (gap > limits.nearest) & limits.is_measured;
      pair.gap = gap + travel_of_links;
      // Which bodies are near is hard to predict: no branch depends on it.
      *kept.candidate = *kept.deferred = pair.pair;
      kept.candidate += (is_near & !waits) ? 1 : 0;
      kept.deferred += waits ? 1 : 0;
    }
    least = std::min(least, pair.gap);
  }
  return least;
}

/// Sorts a list without repetitions.
void sortIds(MarkedPairs& marks, std::vector<PairId>& pairs) noexcept {
  for (const PairId id : pairs) {
    markPair(index(id), marks);
  }
  takeMarked(marks, pairs);
}

/// Lists the pairs that the distance cache does not prove to be far or settled. A group without a
/// near pair keeps the least of their gaps, and is passed over until its links have used that up.
void cullByCache(const NearBodies& near, SettledPairs& settled, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  buffers.candidates.resize(cache.listed.size());
  buffers.deferred.resize(cache.listed.size());
  KeptPairs kept{buffers.candidates.data(), buffers.deferred.data()};
  for (ListedGroup& group : cache.groups) {
    if (isGroupFar(near, group) || (!group.is_of_lone && settled.passOver(group.place))) {
      continue;
    }
    const KeptPairs before = kept;
    const GroupLimits limits = limitsOf(near, buffers.refine, group);
    const double least = keepNear(near, limits, group, cache.listed, kept);
    if (kept.candidate == before.candidate && kept.deferred == before.deferred) {
      group.gap = least;
    }
  }
  buffers.candidates.resize(static_cast<std::size_t>(kept.candidate - buffers.candidates.data()));
  buffers.deferred.resize(static_cast<std::size_t>(kept.deferred - buffers.deferred.data()));
  sortIds(cache.marks, buffers.candidates);
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
