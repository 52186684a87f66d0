// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/deepen_overlaps.h"

#include <algorithm>

namespace collision_monitor {
namespace {

bool isOverlap(const Refinement& all, const RefineTask& task) noexcept {
  return all.work.is_measured[task.pair] != 0 &&
         all.distances.pairs[task.place].quality == Quality::estimate;
}

}  // namespace

void deepenOverlap(const Refinement& all, RefineTask& task, std::uint32_t budget) noexcept {
  PairDistance& overlap = all.distances.pairs[task.place];
  if (!isOverlap(all, task) || overlap.shortfall > 0.0 || !(all.work.work_done < budget)) {
    return;
  }
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementSearch search = searchFor(all, task, {0.0, budget});
  spend(all, task,
        deepenElements(placed(all, pair.a), placed(all, pair.b), all.work.depth_points, search,
                       overlap.measured));
  search.memory.last.found.measured = overlap.measured;
}

void deepenOverlaps(const Refinement& all) noexcept {
  constexpr std::uint32_t kMostPoints = 24;
  constexpr std::uint32_t kFewestPoints = 2;
  std::vector<RefineTask>& tasks = all.work.tasks;
  const auto overlaps = static_cast<std::uint32_t>(std::count_if(
      tasks.begin(), tasks.end(), [&](const RefineTask& task) { return isOverlap(all, task); }));
  all.work.depth_points = std::max(kFewestPoints, kMostPoints / std::max(overlaps, 1U));
  for (RefineTask& task : tasks) {
    deepenOverlap(all, task, shareOf(all));
  }
}

}  // namespace collision_monitor
