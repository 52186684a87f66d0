// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/list_near.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/cycle/near_bodies.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/bound_bodies.h"
#include "pipeline/objects/object_trees.h"

namespace collision_monitor {
namespace {

/// Whether the same bodies move or rest as when the list was made, and each has used less than half
/// of the margin. Unknown motion uses up all.
bool isListGood(const BodyPoses& body_poses, const DistanceCache& cache) noexcept {
  bool is_good = cache.is_listed && cache.listed_moved == body_poses.moved.bodies;
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const BodyTravel& travel = cache.travels[i];
    // A NaN stays one by the order of arguments.
    const double used = travel.all - travel.all_when_listed +
                        std::max(travel.ahead - travel.ahead_when_listed, 0.0);
    is_good &= body_poses.known[i] == 0 || used < 0.5 * kListMargin;
  });
  return is_good;
}

/// Whether motions are known, and so slow that a list serves for some cycles. It needs boxes grown
/// by its margin: objects without trees keep those of the cycle in which they last moved.
bool isWorthListing(const CycleSetup& setup, const CycleBuffers& buffers) noexcept {
  constexpr double kFewCycles = 4.0;
  const BodyPoses& body_poses = buffers.body_poses;
  const DistanceCache& cache = buffers.memory.distance_cache;
  const std::vector<ObjectTree>& trees = buffers.trees.trees;
  bool is_worth = trees.size() == setup.carried.size() &&
                  std::all_of(trees.begin(), trees.end(),
                              [](const ObjectTree& tree) { return tree.are_known; });
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const BodyTravel& travel = cache.travels[i];
    const bool is_slow = kFewCycles * travel.of_link < 0.5 * kListMargin;
    is_worth &= body_poses.known[i] == 0 || (!std::isnan(travel.ahead) && is_slow);
  });
  return is_worth;
}

/// Removes pairs of two parts: relative poses of these mean nothing.
void dropUnjoined(const CycleSetup& setup, const BodyPoses& body_poses,
                  std::vector<PairId>& candidates) noexcept {
  if (!body_poses.is_split) {
    return;
  }
  const auto is_apart = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    return !isJoined(body_poses, setup.bodies[index(pair.a)].link,
                     setup.bodies[index(pair.b)].link);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_apart),
                   candidates.end());
}

/// Finds the pairs whose bounds meet. @param margin [m] how much farther than matters they may be
void findCandidates(const CycleSetup& setup, const LinkPoses& poses, double margin,
                    CycleBuffers& buffers) noexcept {
  const double reach = farthestActivationDistanceOf(setup) + margin;
  boundBodies(setup, buffers.body_poses, reach, buffers.bounds);
  if (setup.is_continuous) {
    sweepBounds(setup, buffers.body_poses, buffers.sweep, reach, buffers.bounds);
  }
  growBounds(buffers.body_poses, buffers.bounds);
  findPairs(setup, poses, reach, margin, buffers);
  dropUnjoined(setup, buffers.body_poses, buffers.candidates);
  buffers.counters.candidates = buffers.candidates.size();
}

/// Drops the candidates that the cache proves to be far for as long as a list serves.
void dropFar(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  constexpr double kRounding = 1e-9;  // of the cached distance
  DistanceCache& cache = buffers.memory.distance_cache;
  const NearBodies near = nearBodies(setup, poses, buffers);
  const auto is_far = [&](PairId id) {
    const BodyTravel& a = cache.travels[index(setup.table[id].a)];
    const BodyTravel& b = cache.travels[index(setup.table[id].b)];
    const double gap = cache.distances[index(id)] - (a.all + b.all) - kRounding;
    return gap > near.highestLimitOf(a, b) + kListMargin;
  };
  std::vector<PairId>& candidates = buffers.candidates;
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_far), candidates.end());
}

/// Notes the motion by which isListGood tells how long the list serves.
void noteMotion(const BodyPoses& body_poses, const BodyBounds& bounds,
                DistanceCache& cache) noexcept {
  const std::vector<IndexRange>& moved = body_poses.moved.bodies;
  cache.listed_moved.assign(moved.begin(), moved.end());
  forIndices(moved, [&](std::size_t i) noexcept {
    cache.travels[i].all_when_listed = cache.travels[i].all;
    cache.travels[i].ahead_when_listed = bounds.ahead[i];  // by this, boxes were grown
  });
}

/// Where the index of a pair's group is kept; kNone before it is met.
std::uint32_t& groupOf(const CycleSetup& setup, PairId id, DistanceCache& cache) noexcept {
  return areLone(cache, setup.table[id]) ? cache.group_of_lone[setup.link_pair_of[index(id)]]
                                         : cache.group_of[setup.element_pair_of[index(id)]];
}

/// Makes the groups of the candidates. `last` counts the pairs of each.
void makeGroups(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  const NearBodies near = nearBodies(setup, poses, buffers);
  DistanceCache& cache = buffers.memory.distance_cache;
  cache.groups.clear();
  for (const PairId id : buffers.candidates) {
    std::uint32_t& group = groupOf(setup, id, cache);
    if (group == kNone) {
      group = static_cast<std::uint32_t>(cache.groups.size());
      cache.groups.push_back({near.placeOf(id), areLone(cache, setup.table[id])});
    }
    ++cache.groups[group].last;
  }
}

/// Lists the candidates group by group.
void listGroups(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  makeGroups(setup, poses, buffers);
  std::uint32_t first = 0;
  for (ListedGroup& group : cache.groups) {
    group.first = std::exchange(first, first + group.last);
    group.last = group.first;
  }
  cache.listed.resize(first);
  for (const PairId id : buffers.candidates) {
    const BodyPair& pair = setup.table[id];
    cache.listed[cache.groups[groupOf(setup, id, cache)].last++] = {id, pair.a, pair.b};
  }
  for (const ListedGroup& group : cache.groups) {
    cache.group_of[group.place.elements] = kNone;
    cache.group_of_lone[group.place.link_pair] = kNone;
  }
}

}  // namespace

void listNear(const CycleSetup& setup, const LinkPoses& poses, bool have_links_changed,
              CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  growTrees(setup, buffers);
  if (have_links_changed || !isListGood(buffers.body_poses, cache)) {
    // After a change few distances are known.
    cache.is_listed = !have_links_changed && isWorthListing(setup, buffers);
    findCandidates(setup, poses, cache.is_listed ? kListMargin : 0.0, buffers);
    if (cache.is_listed) {
      dropFar(setup, poses, buffers);
      noteMotion(buffers.body_poses, buffers.bounds, cache);
    }
    listGroups(setup, poses, buffers);
  }
}

}  // namespace collision_monitor
