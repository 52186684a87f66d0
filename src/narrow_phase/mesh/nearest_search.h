// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_front/front_entries.h"

/// Branch and bound for the nearest points of a mesh and something else.
namespace collision_monitor {

/// The nearest points so far, and the state of the search for them.
struct NearestSearch {
  PointPair best;
  TrianglePair nearest;
  double tolerance{0.0};  ///< [m] pairs that are nearer than the best by less may be skipped
  double rounding{0.0};   ///< [m] a difference of distances this small means nothing
  double radius{0.0};     ///< [m] by which one of the two is inflated
  double at_least{0.0};   ///< [m] what is known of the distance before
  std::uint32_t visits{0};
  double squared_open{std::numeric_limits<double>::infinity()};  ///< least bound left unopened
  double squared_left{std::numeric_limits<double>::infinity()};  ///< least of all skipped
  MeshFront* front{nullptr};  ///< keeps what is skipped, if there is one
  MovingBounds moving;        ///< of the front
  /// The node pair of `nearest`.
  MeshQueryMemory::NodePair bounds{0.0F, kNone, kNone};
  std::uint32_t towards{0};  ///< with a front: from A to B where they are nearest, as `packed`

  /// False if the budget ended the search before it was certain.
  bool isComplete() const noexcept { return squaredGoal() <= squared_open; }

  /// [m] Pairs that are nearer than the best by less than this are skipped: the tolerance, but at
  /// most half of the distance of what is inflated.
  double skipped() const noexcept {
    const double distance = std::sqrt(best.squared_distance);
    return std::min(tolerance, 0.5 * std::max(0.0, distance - radius));
  }

  /// [m^2] Node pairs this far or farther are skipped.
  double squaredGoal() const noexcept {
    if (tolerance <= 0.0 || nearest.a == kNone) {
      return best.squared_distance;
    }
    const double goal = std::sqrt(best.squared_distance) - skipped();
    return at_least > 0.0 && goal <= at_least ? 0.0 : goal * goal;
  }

  /// [m^2] A lower bound of the distance. It is the best if the two differ by rounding alone.
  double squaredBound() const noexcept {
    constexpr double kWithGoal = 2.0;  // the goal is one rounding below the best, and rounded
    const double bound = std::max({squaredGoal(), squared_left, at_least * at_least});
    const double short_by = std::sqrt(best.squared_distance) - std::sqrt(bound);
    return short_by > kWithGoal * rounding ? bound : best.squared_distance;
  }

  /// [m^2] Triangles farther than this are not measured.
  double squaredReach() const noexcept {
    return front == nullptr ? best.squared_distance
                            : collision_monitor::squaredReach(best.squared_distance, *front);
  }

  /// Skips a node pair. @param direction, children: as FrontEntry.
  void leave(const MeshQueryMemory::NodePair& pair, double squared_bound,
             std::uint32_t direction = 0, std::uint32_t children = 0) noexcept {
    squared_left = std::min(squared_left, squared_bound);
    if (front != nullptr && pair.a != kNone) {
      keep({{pair.a, pair.b}, std::sqrt(squared_bound), direction, children}, moving, *front);
    }
  }
};

/// Measures two triangles by `measure(start, squared_cutoff)`. Keeps their points if nearer. With a
/// front, the direction of the nearest points so far is tried before.
/// @param bounds the node pair of the triangles, if the search has a front.
/// @param gapAlong [m^2] how far a direction separates the triangles, as squaredGapAlong. At 0 they
/// may overlap along it by any length, so no bound of the next query follows from it.
template <class Measure, class GapAlong>
void offer(const TrianglePair& triangles, const MeshQueryMemory::NodePair& bounds,
           NearestSearch& search, const Measure& measure, const GapAlong& gapAlong) noexcept {
  const bool is_nearest = bounds.a == search.bounds.a && bounds.b == search.bounds.b;
  if (search.towards != 0 && !is_nearest) {
    const double along = gapAlong(directionOf(search.towards));
    if (along > 0.0 && along >= search.squaredGoal()) {
      search.leave(bounds, along, search.towards);
      return;
    }
  }
  PointPair start = search.best;
  start.squared_distance = search.squaredReach();
  const TriangleDistance found = measure(start, search.squaredGoal());
  search.visits += found.visits - 1;
  if (found.nearest.squared_distance < search.best.squared_distance) {
    search.leave(search.bounds, search.best.squared_distance);
    search.best = found.nearest;
    search.nearest = triangles;
    search.bounds = bounds;
    search.towards = search.front == nullptr ? 0 : packed(found.nearest.on_b - found.nearest.on_a);
  } else if (!is_nearest) {
    const std::uint32_t direction = search.front == nullptr ? 0 : packed(found.direction);
    const double along = direction == 0 ? 0.0 : gapAlong(directionOf(direction));
    const bool suffices = along > 0.0 && along >= search.squaredGoal();
    search.leave(bounds, suffices ? along : found.squared_bound, suffices ? direction : 0);
  } else if (bounds.a == kNone) {
    search.squared_left = std::min(search.squared_left, found.squared_bound);
  }
}

/// Branch and bound over the queue, the nearest bound first. `open(pair, limit, queue)` measures
/// two triangles, or queues the children of one side whose squared bound is below the limit.
/// @param cutoff [m] the search ends once something is this near.
template <class Open>
void branchAndBound(double cutoff, std::uint32_t visit_budget, NodePairQueue& queue,
                    NearestSearch& search, const Open& open) noexcept {
  while (!queue.empty() && search.best.squared_distance > cutoff * cutoff) {
    const MeshQueryMemory::NodePair next = queue.pop();
    const auto bound = static_cast<double>(next.squared_bound);
    if (!(next.squared_bound < asLimit(search.squaredGoal()))) {
      search.leave(next, bound);
      continue;
    }
    if (search.visits >= visit_budget) {
      search.squared_open = std::min(search.squared_open, queue.leastBound(bound));
      search.leave(next, bound);
      break;
    }
    ++search.visits;
    open(next, asLimit(search.best.squared_distance), queue);
  }
  while (search.front != nullptr && !queue.empty()) {
    const MeshQueryMemory::NodePair next = queue.pop();
    search.leave(next, static_cast<double>(next.squared_bound));
  }
}

}  // namespace collision_monitor
