// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/deepen_overlaps.h"

#include <algorithm>

namespace collision_monitor {
namespace {

constexpr std::uint32_t kMostPoints = 24;  // that a cycle tries

bool isMeasuredOverlap(const Refinement& all, const RefineTask& task) noexcept {
  const PairDistance& distance = all.distances.pairs[task.place];
  return all.work.is_measured[task.pair] != 0 && distance.quality == Quality::estimate &&
         !(distance.shortfall > 0.0);
}

/// @param points to try at most
void deepen(const Refinement& all, RefineTask& task, std::uint32_t budget,
            std::uint32_t points) noexcept {
  if (!isMeasuredOverlap(all, task) || !(all.work.work_done < budget)) {
    return;
  }
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementSearch search = searchFor(all, task, {0.0, budget});
  SignedDistance& overlap = all.distances.pairs[task.place].measured;
  spend(all, task,
        deepenElements(placed(all, pair.a), placed(all, pair.b), points, search, overlap));
  search.memory.last.found.measured = overlap;
}

}  // namespace

void deepenOverlaps(const Refinement& all) noexcept {
  constexpr std::uint32_t kFewestPoints = 2;
  std::vector<RefineTask>& tasks = all.work.tasks;
  const auto overlaps = std::count_if(tasks.begin(), tasks.end(), [&](const RefineTask& task) {
    return isMeasuredOverlap(all, task);
  });
  const std::uint32_t points =
      overlaps == 0 ? 0 : kMostPoints / static_cast<std::uint32_t>(overlaps);
  for (RefineTask& task : tasks) {
    deepen(all, task, shareOf(all), std::max(kFewestPoints, points));
  }
}

void deepenOverlap(const Refinement& all, RefineTask& task, std::uint32_t budget) noexcept {
  deepen(all, task, budget, kMostPoints);
}

}  // namespace collision_monitor
