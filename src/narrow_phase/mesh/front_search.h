// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/mesh/nearest_search.h"

/// Branch and bound from what the last search left. A query has:
/// - areTriangles(a, b): whether nothing of a pair can be opened;
/// - measure(bounds, search): two triangles, or a triangle and a solid;
/// - squaredGapAlong(direction, a, b) [m^2]: a lower bound of the same;
/// - open(a, b, limit, opened): as openPair.
namespace collision_monitor {

/// The waiting pairs that a front gives: the nearest stays on top.
class TakenPairs {
 public:
  explicit TakenPairs(WaitingPairs& waiting) noexcept : waiting_(waiting) {}

  /// Whether there is room for all children of a bound.
  bool hasRoom() const noexcept { return size_ + MeshTreeNode::kWidth <= MeshFront::kCapacity; }

  void push(MeshQueryMemory::Waiting next) noexcept {
    ++size_;
    if (next.squared_bound > least_) {
      const MeshQueryMemory::Waiting nearest = waiting_.pop();
      waiting_.push(next);
      next = nearest;
    }
    waiting_.push(next);
    least_ = next.squared_bound;
  }

 private:
  WaitingPairs& waiting_;
  std::uint32_t size_{0};
  float least_{std::numeric_limits<float>::infinity()};
};

constexpr std::uint32_t kAllChildren = (1U << MeshTreeNode::kWidth) - 1;
constexpr float kNoChild = 1e30F;  ///< [m^2] beyond it slots are empty

/// [m^2] Least bound of some children; kNoChild if there are none.
inline float leastBound(const OpenedPair& opened, std::uint32_t children) noexcept {
  float least = kNoChild;
  for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
    const float bound = (children >> slot & 1U) != 0 ? opened.bounds.squared[slot] : kNoChild;
    least = std::min(least, bound);
  }
  return least;
}

/// A kept pair that may have come nearer than the limit, bounded anew.
struct BoundedPair {
  MeshFront::Kept kept;
  float squared_bound;  ///< [m^2] of what is kept of it; kNoChild: nothing
};

template <class Query>
BoundedPair boundTriangles(const Query& query, const MeshFront::Kept& kept, float old_bound,
                           float limit, TakenPairs& taken) noexcept {
  constexpr float kRoundedDown = 1.0F - std::numeric_limits<float>::epsilon();
  if (kept.detail != 0) {
    const double squared = query.squaredGapAlong(directionOf(kept.detail), kept.a, kept.b);
    const float along = kRoundedDown * static_cast<float>(std::min(squared, 1e29));
    if (!(along < limit)) {
      return {kept, along};
    }
  }
  taken.push({old_bound, kept.a, kept.b});
  return {kept, kNoChild};
}

/// Takes the children that are nearer than the limit.
template <class Query>
BoundedPair boundChildren(const Query& query, const MeshFront::Kept& kept, float limit,
                          TakenPairs& taken) noexcept {
  OpenedPair opened;
  query.open(kept.a, kept.b, limit, opened);
  const std::uint32_t meant = kept.detail == 0 ? kAllChildren : kept.detail;
  for (std::uint32_t nearer = opened.nearer & meant; nearer != 0; nearer &= nearer - 1) {
    taken.push(opened.childAt(static_cast<std::uint32_t>(__builtin_ctz(nearer))));
  }
  const std::uint32_t rest = meant & ~opened.nearer;
  return {{kept.a, kept.b, rest}, leastBound(opened, rest)};
}

/// Bounds a kept pair anew. @return whether something of it is still kept in its place.
template <class Query>
bool boundAnew(const Query& query, std::uint32_t at, float limit, MeshFront& front,
               TakenPairs& taken) noexcept {
  const MeshFront::Kept kept = front.kept[at];
  const BoundedPair found =
      query.areTriangles(kept.a, kept.b)
          ? boundTriangles(query, kept, boundDue(front.due[at], front), limit, taken)
          : boundChildren(query, kept, limit, taken);
  if (!(found.squared_bound < kNoChild)) {
    drop(at, front);
    return false;
  }
  front.kept[at] = found.kept;
  front.due[at] = dueOf(static_cast<double>(found.squared_bound), front);
  return true;
}

/// Bounds anew the pairs that may have come nearer than the goal, and lets those wait that have,
/// the nearest on top; keeps the rest. What there is no budget for is as far as it was known.
/// @return false where there was no room, and the search has to start from the roots.
template <class Query>
bool takeNearer(const Query& query, std::uint32_t visit_budget, WaitingPairs& waiting,
                NearestSearch& search) noexcept {
  // To bound a pair anew takes a part of what opening one does.
  constexpr std::uint32_t kBoundsPerVisit = 2;
  MeshFront& front = *search.front;
  const float now = dueNow(search.squaredGoal(), front);
  const float limit = asLimit(search.squaredGoal());
  TakenPairs taken(waiting);
  float least_due = std::numeric_limits<float>::infinity();
  std::uint32_t bounded = 0;
  bool is_complete = true;
  const std::uint32_t most = visit_budget / 2 * kBoundsPerVisit;  // the other half opens pairs
  for (std::uint32_t i = 0; i < front.size;) {
    const bool is_due = front.due[i] < now;
    if (is_due && !taken.hasRoom()) {
      search.visits += bounded / kBoundsPerVisit;
      return false;
    }
    const bool is_bounded = is_due && bounded < most;
    bounded += is_bounded ? 1 : 0;
    if (is_bounded && !boundAnew(query, i, limit, front, taken)) {
      continue;  // another one has taken its place
    }
    is_complete = is_complete && is_bounded == is_due;
    least_due = std::min(least_due, front.due[i]);
    ++i;
  }
  const double left =
      std::max(std::min(static_cast<double>(least_due), front.cover) - front.moved, 0.0);
  search.squared_left = std::min(search.squared_left, left * left);
  search.squared_open = is_complete ? search.squared_open : left * left;
  search.visits += bounded / kBoundsPerVisit;
  return true;
}

/// Measures triangles, or lets the children of a bound wait that are nearer than the goal; the
/// others are kept as one.
template <class Query>
void lookAt(const Query& query, const MeshQueryMemory::Waiting& next, WaitingPairs& waiting,
            NearestSearch& search) noexcept {
  if (query.areTriangles(next.a, next.b)) {
    query.measure(next, search);
    return;
  }
  OpenedPair opened;
  query.open(next.a, next.b, asLimit(search.squaredGoal()), opened);
  waiting.pushNearer(opened);
  const std::uint32_t rest = kAllChildren & ~opened.nearer;
  const float least = leastBound(opened, rest);
  if (least < kNoChild) {
    search.leave(next, static_cast<double>(least), rest);
  }
}

/// From the pairs that the last query kept, if nothing else can be nearer; else from the roots.
/// @param step what `follow` said. @param enough [m] what is so near ends the search.
template <class Query>
void searchFromFront(const Query& query, double step, double enough, std::uint32_t visit_budget,
                     WaitingPairs& waiting, NearestSearch& search) noexcept {
  MeshFront& front = *search.front;
  if (front.nearest.a != MeshFront::kNone) {
    query.measure({0.0F, front.nearest.a, front.nearest.b}, search);
  }
  setMargin(step, search.best.squared_distance, front);
  if (search.best.squared_distance > enough * enough) {
    const bool is_near =
        covers(search.squaredGoal(), front) && takeNearer(query, visit_budget, waiting, search);
    if (!is_near) {
      restart(front);
      waiting.clear();
      waiting.push({0.0F, 0, 0});
    }
    searchNearest(enough, visit_budget, waiting, search,
                  [&](const MeshQueryMemory::Waiting& next, float, WaitingPairs& pairs) {
                    lookAt(query, next, pairs, search);
                  });
    front.from_roots += front.is_whole ? 0 : search.visits;
    front.is_whole = front.is_whole || search.isComplete();
  }
  front.nearest = {search.bounds.a, search.bounds.b};
}

}  // namespace collision_monitor
