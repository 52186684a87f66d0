// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh_front/bound_anew.h"

/// Branch and bound from what the last search left. A query has what bound_anew.h asks for, and
/// measure(bounds, search), which measures two triangles, or a triangle and a solid.
namespace collision_monitor {

/// Bounds again the pairs that may have come nearer than the goal. Queues those that have, the
/// nearest on top, and keeps the rest. Pairs that the budget leaves out keep their bounds.
/// @return false if there was no room: the search must start from the roots.
template <class Query>
bool takeNearer(const Query& query, std::uint32_t visit_budget, NodePairQueue& queue,
                NearestSearch& search) noexcept {
  MeshFront& front = *search.front;
  const float goal = roundedUp(std::sqrt(search.squaredGoal()));
  const float limit = asLimit(search.squaredGoal());
  TakenPairs taken(queue);
  const std::uint32_t left = visit_budget - std::min(visit_budget, search.visits);
  const std::uint32_t last = search.visits + left / 2;  // the other half opens pairs
  std::uint32_t at = nextBelow(goal, 0, front);
  while (at < front.size && search.visits < last && taken.hasRoom()) {
    ++search.visits;
    const bool is_kept = boundAnew(query, at, limit, search, taken);
    at = nextBelow(goal, is_kept ? at + 1 : at, front);  // else another one has taken its place
  }
  if (at < front.size && !taken.hasRoom()) {
    return false;
  }
  const double least = std::max(std::min(static_cast<double>(leastBound(front)), front.cover), 0.0);
  search.squared_left = std::min(search.squared_left, least * least);
  search.squared_open = at == front.size ? search.squared_open : least * least;
  return true;
}

/// Measures triangles, or queues the children of a bound that are nearer than the goal and keeps
/// the others as one entry.
template <class Query>
void lookAt(const Query& query, const MeshQueryMemory::NodePair& next, NodePairQueue& queue,
            NearestSearch& search) noexcept {
  if (query.areTriangles(next.a, next.b)) {
    query.measure(next, search);
    return;
  }
  FrontEntry entry{{next.a, next.b}, 0.0, 0, 0};
  if (query.areParts(next.a, next.b) &&
      separateParts(query, std::sqrt(search.squaredGoal()), entry, search)) {
    search.leave(next, entry.bound * entry.bound, entry.direction);
    return;
  }
  OpenedPair opened;
  query.choose(next.a, next.b, opened);
  boundChildren(asLimit(search.squaredGoal()), opened);
  queue.pushNearer(opened);
  const std::uint32_t rest = kAllChildren & ~opened.nearer;
  const float least = leastBound(opened, rest);
  if (least < kNoChild) {
    search.leave(next, static_cast<double>(least), 0, rest);
  }
}

template <class Query>
void searchQueued(const Query& query, double cutoff, std::uint32_t visit_budget,
                  NodePairQueue& queue, NearestSearch& search) noexcept {
  branchAndBound(cutoff, visit_budget, queue, search,
                 [&](const MeshQueryMemory::NodePair& next, float, NodePairQueue& pairs) {
                   lookAt(query, next, pairs, search);
                 });
}

template <class Query>
void searchFromRoots(const Query& query, double cutoff, std::uint32_t visit_budget,
                     NodePairQueue& queue, NearestSearch& search) noexcept {
  restart(*search.front);
  queue.clear();
  queue.push({0.0F, 0, 0});
  searchQueued(query, cutoff, visit_budget, queue, search);
}

/// Searches from the roots once more: as the nearest triangles are known now, the front that is
/// left is much smaller. The answer stays.
template <class Query>
void shrinkFront(const Query& query, double cutoff, std::uint32_t visit_budget,
                 NodePairQueue& queue, NearestSearch& search) noexcept {
  const double squared_left = search.squared_left;
  search.squared_left = std::numeric_limits<double>::infinity();
  searchFromRoots(query, cutoff, visit_budget, queue, search);
  if (!search.isComplete()) {
    search.squared_open = std::numeric_limits<double>::infinity();
    search.squared_left = squared_left;
  }
}

/// Searches from the pairs that the last query kept, or from the roots if others may be nearer.
/// @param step from `follow`. @param cutoff [m] the search ends once something is this near.
template <class Query>
void searchFromFront(const Query& query, double step, double cutoff, std::uint32_t visit_budget,
                     NodePairQueue& queue, NearestSearch& search) noexcept {
  constexpr std::uint32_t kPairsPerVisit = 128;  // pairs loosened in the time of a visit
  MeshFront& front = *search.front;
  search.visits += step > 0.0 ? front.size / kPairsPerVisit : 0;
  if (front.nearest.a != kNone) {
    query.measure({0.0F, front.nearest.a, front.nearest.b}, search);
  }
  setMargin(step, search.best.squared_distance, front);
  if (search.best.squared_distance > cutoff * cutoff) {
    if (covers(search.squaredGoal(), front) && takeNearer(query, visit_budget, queue, search)) {
      searchQueued(query, cutoff, visit_budget, queue, search);
    } else {
      const bool is_first = front.nearest.a == kNone;
      searchFromRoots(query, cutoff, visit_budget, queue, search);
      if (is_first && search.isComplete() && search.nearest.a != kNone) {
        shrinkFront(query, cutoff, visit_budget, queue, search);
      }
    }
    front.from_roots += front.is_whole ? 0 : search.visits;
    front.is_whole = front.is_whole || search.isComplete();
  }
  front.nearest = {search.bounds.a, search.bounds.b};
}

}  // namespace collision_monitor
