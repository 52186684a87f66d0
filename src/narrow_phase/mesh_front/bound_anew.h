// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "narrow_phase/mesh/nearest_search.h"
#include "narrow_phase/mesh/part_gap.h"
#include "narrow_phase/mesh_front/front_lanes.h"

/// Bounds pairs of a front again. A query has:
/// - areTriangles(a, b): true if neither side of a pair can be opened;
/// - squaredGapAlong(direction, a, b) [m^2]: a lower bound of the squared distance of triangles;
/// - choose(a, b, opened): as for two meshes;
/// - restingFromNode(opened): as for directionFor;
/// - areParts(a, b), gapOfParts(a, b, direction) and searchGapOfParts(a, b, goal): as in
/// part_gap.h.
namespace collision_monitor {

/// Queues the pairs taken from a front. The nearest stays on top.
class TakenPairs {
 public:
  explicit TakenPairs(NodePairQueue& queue) noexcept : queue_(queue) {}

  /// True if there is room for all children of a bound.
  bool hasRoom() const noexcept { return size_ + MeshTreeNode::kWidth <= MeshFront::kCapacity; }

  void push(MeshQueryMemory::NodePair next) noexcept {
    ++size_;
    if (next.squared_bound > least_) {
      const MeshQueryMemory::NodePair nearest = queue_.pop();
      queue_.push(next);
      next = nearest;
    }
    queue_.push(next);
    least_ = next.squared_bound;
  }

 private:
  NodePairQueue& queue_;
  std::uint32_t size_{0};
  float least_{std::numeric_limits<float>::infinity()};
};

constexpr std::uint32_t kAllChildren = (1U << MeshTreeNode::kWidth) - 1;
constexpr float kNoChild = 1e30F;  ///< [m^2] empty slots are beyond it

/// [m^2] Square of a bound, rounded down; 0 if motion has used the bound up.
inline float squaredBound(double bound) noexcept {
  constexpr double kRoundedDown = 1.0 - std::numeric_limits<float>::epsilon();
  return static_cast<float>(kRoundedDown * std::max(bound, 0.0) * std::max(bound, 0.0));
}

/// [m^2] Least squared bound of some children; kNoChild if there are none.
inline float leastBound(const OpenedPair& opened, std::uint32_t children) noexcept {
  float least = kNoChild;
  for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
    const float bound = (children >> slot & 1U) != 0 ? opened.bounds.squared[slot] : kNoChild;
    least = std::min(least, bound);
  }
  return least;
}

/// Takes two triangles if the direction that separated them does so no longer.
template <class Query>
bool boundTriangles(const Query& query, float limit, FrontEntry& entry,
                    TakenPairs& taken) noexcept {
  if (entry.direction != 0) {
    const auto& [a, b] = entry.pair;
    const double squared = query.squaredGapAlong(directionOf(entry.direction), a, b);
    if (squared > 0.0 && !(squared < static_cast<double>(limit))) {
      entry.bound = std::sqrt(squared);
      return true;
    }
  }
  taken.push({squaredBound(entry.bound), entry.pair.a, entry.pair.b});
  return false;
}

/// [m] Least gap of some children; infinity if there are none.
inline float leastOf(const std::array<float, MeshTreeNode::kWidth>& gaps,
                     std::uint32_t children) noexcept {
  float least = std::numeric_limits<float>::infinity();
  for (; children != 0; children &= children - 1) {
    least = std::min(least, gaps[static_cast<std::size_t>(__builtin_ctz(children))]);
  }
  return least;
}

/// Keeps children with a direction that separates the nearest of them. Those that it separates much
/// less get an entry of their own.
template <class Query>
void keepParted(const Query& query, const OpenedPair& opened, double goal, FrontEntry& entry,
                const NearestSearch& search) noexcept {
  constexpr double kNearly = 0.25;
  const auto& resting_from_node = query.restingFromNode(opened);
  const std::uint32_t all = entry.children;
  entry.direction = 0;
  entry.bound = std::sqrt(static_cast<double>(leastBound(opened, all)));
  const std::uint32_t direction = directionFor(opened, all, resting_from_node);
  if (direction == 0) {
    return;
  }
  const auto gaps = gapsAlong(direction, opened, resting_from_node);
  const double cutoff = goal + kNearly * (entry.bound - goal);
  std::uint32_t parted = 0;
  for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
    parted |= static_cast<double>(gaps[slot]) > cutoff ? 1U << slot : 0U;
  }
  parted &= all;
  const std::uint32_t others = all & ~parted;
  if (parted == 0 || (others != 0 && !ensureRoom(*search.front))) {
    return;
  }
  entry.children = parted;
  entry.direction = direction;
  entry.bound = static_cast<double>(leastOf(gaps, parted));
  if (others != 0) {
    keep({entry.pair, std::sqrt(static_cast<double>(leastBound(opened, others))), 0, others},
         search.moving, *search.front);
  }
}

/// Looks for a direction that separates two parts by more than a goal [m], first along that of the
/// entry. @return true if there is one; then the entry has it.
template <class Query>
bool separateParts(const Query& query, double goal, FrontEntry& entry,
                   NearestSearch& search) noexcept {
  const auto& [a, b] = entry.pair;
  if (entry.direction != 0) {
    entry.bound = query.gapOfParts(a, b, directionOf(entry.direction));
    if (entry.bound > goal) {
      return true;
    }
  }
  const PartGap found = query.searchGapOfParts(a, b, goal);
  search.visits += found.visits;
  if (!(found.gap > goal)) {
    return false;
  }
  const std::uint32_t rounded = packed(found.direction);
  const double gap = query.gapOfParts(a, b, directionOf(rounded));
  const bool suffices = gap > goal;
  entry.direction = suffices ? rounded : 0;
  entry.bound = suffices ? gap : found.gap;
  return true;
}

/// Takes the children nearer than the limit, unless the direction that separated all still does.
template <class Query>
bool boundChildren(const Query& query, float limit, FrontEntry& entry, NearestSearch& search,
                   TakenPairs& taken) noexcept {
  const double goal = std::sqrt(static_cast<double>(limit));
  if (entry.children == 0 && query.areParts(entry.pair.a, entry.pair.b) &&
      separateParts(query, goal, entry, search)) {
    return true;
  }
  const std::uint32_t meant = entry.children == 0 ? kAllChildren : entry.children;
  OpenedPair opened;
  query.choose(entry.pair.a, entry.pair.b, opened);
  if (entry.direction != 0) {
    const auto gaps = gapsAlong(entry.direction, opened, query.restingFromNode(opened));
    entry.bound = static_cast<double>(leastOf(gaps, meant));
    if (entry.bound > goal) {
      return true;
    }
  }
  collision_monitor::boundChildren(limit, opened);
  for (std::uint32_t nearer = opened.nearer & meant; nearer != 0; nearer &= nearer - 1) {
    taken.push(opened.childAt(static_cast<std::uint32_t>(__builtin_ctz(nearer))));
  }
  entry.children = meant & ~opened.nearer;
  if (!(leastBound(opened, entry.children) < kNoChild)) {
    return false;
  }
  keepParted(query, opened, goal, entry, search);
  return true;
}

/// Bounds again a kept pair that may have come nearer than the limit.
/// @return true if some of it is still kept in its place.
template <class Query>
bool boundAnew(const Query& query, std::uint32_t at, float limit, NearestSearch& search,
               TakenPairs& taken) noexcept {
  MeshFront& front = *search.front;
  FrontEntry entry = entryAt(at, front);
  const bool is_kept = query.areTriangles(entry.pair.a, entry.pair.b)
                           ? boundTriangles(query, limit, entry, taken)
                           : boundChildren(query, limit, entry, search, taken);
  if (is_kept) {
    renew(at, entry, front);
  } else {
    drop(at, front);
  }
  return is_kept;
}

}  // namespace collision_monitor
