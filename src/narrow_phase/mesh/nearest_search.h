// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_front.h"
#include "narrow_phase/mesh/mesh_search.h"

/// Branch and bound for the nearest points of a mesh and something else.
namespace collision_monitor {

/// The nearest points so far, and how the search for them went.
struct NearestSearch {
  PointPair best;
  TrianglePair nearest;
  std::uint32_t visits{0};
  double squared_open{std::numeric_limits<double>::infinity()};  ///< least bound left unopened
  MeshFront* front{nullptr};  ///< keeps what is left, if there is one
  /// Where `nearest` hangs.
  MeshQueryMemory::Waiting bounds{0.0F, MeshFront::kNone, MeshFront::kNone};

  /// False when the budget ended the search before it was certain.
  bool isComplete() const noexcept { return best.squared_distance <= squared_open; }

  /// [m^2] What is farther is neither looked at nor kept.
  double squaredReach() const noexcept {
    return front == nullptr ? best.squared_distance
                            : collision_monitor::squaredReach(best.squared_distance, *front);
  }

  void leave(const MeshQueryMemory::Waiting& pair, double squared_bound) const noexcept {
    if (front != nullptr && pair.a != MeshFront::kNone) {
      keep(pair.a, pair.b, squared_bound, *front);
    }
  }
};

/// Replaces the nearest points by those that `measure(start, squared_enough)` gives for two
/// triangles, if they are nearer.
/// @param bounds where the triangles hang, if the search has a front.
template <class Measure>
void offer(const TrianglePair& triangles, const MeshQueryMemory::Waiting& bounds,
           NearestSearch& search, const Measure& measure) noexcept {
  PointPair start = search.best;
  start.squared_distance = search.squaredReach();
  const TriangleDistance found = measure(start, search.best.squared_distance);
  if (found.nearest.squared_distance < search.best.squared_distance) {
    search.leave(search.bounds, search.best.squared_distance);
    search.best = found.nearest;
    search.nearest = triangles;
    search.bounds = bounds;
  } else if (bounds.a != search.bounds.a || bounds.b != search.bounds.b) {
    search.leave(bounds, found.squared_bound);
  }
}

/// Branch and bound from the pairs that wait, the nearest bound first. `open(pair, limit, waiting)`
/// measures two triangles, or lets the children of one bound wait.
/// @param enough [m] what is so near ends the search.
template <class Open>
void searchNearest(double enough, std::uint32_t visit_budget, WaitingPairs& waiting,
                   NearestSearch& search, const Open& open) noexcept {
  while (!waiting.empty() && search.best.squared_distance > enough * enough) {
    const MeshQueryMemory::Waiting next = waiting.pop();
    const auto bound = static_cast<double>(next.squared_bound);
    if (!(next.squared_bound < asLimit(search.best.squared_distance))) {
      search.leave(next, bound);
      continue;
    }
    if (search.visits >= visit_budget) {
      search.squared_open = waiting.leastBound(bound);
      search.leave(next, bound);
      break;
    }
    ++search.visits;
    open(next, asLimit(search.squaredReach()), waiting);
  }
  while (search.front != nullptr && !waiting.empty()) {
    const MeshQueryMemory::Waiting next = waiting.pop();
    search.leave(next, static_cast<double>(next.squared_bound));
  }
}

}  // namespace collision_monitor
