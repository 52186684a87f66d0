// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/refine_tasks.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// False for two bodies that are their elements: their distance is already that of the elements.
bool isRefinable(const CycleSetup& setup, ElementPairIndex pair) noexcept {
  const ElementPair& elements = setup.element_pairs[pair];
  return !setup.elements[index(elements.a)].is_body || !setup.elements[index(elements.b)].is_body;
}

void forgetLastCycle(const CycleSetup& setup, RefineWork& work) noexcept {
  for (const RefineTask& task : work.tasks) {
    work.task_of[task.pair] = kNone;
    work.is_measured[task.pair] = 0;
    work.nearest[setup.element_pairs[task.pair].link_pair] =
        std::numeric_limits<double>::infinity();
  }
  work.tasks.clear();
  work.refined = work.left = work.work_done = 0;
}

void sortTasks(RefineWork& work) noexcept {
  std::sort(work.tasks.begin(), work.tasks.end(), [](const RefineTask& x, const RefineTask& y) {
    return std::tie(y.starved_cycles, x.bound, x.pair) <
           std::tie(x.starved_cycles, y.bound, y.pair);
  });
  for (std::uint32_t i = 0; i < work.tasks.size(); ++i) {
    work.task_of[work.tasks[i].pair] = i;
  }
}

}  // namespace

void listTasks(const CycleSetup& setup, const PairMemory& memory, const PairDistances& distances,
               RefineWork& work) noexcept {
  forgetLastCycle(setup, work);
  for (std::uint32_t i = 0; i < distances.pairs.size(); ++i) {
    const PairDistance& distance = distances.pairs[i];
    const ElementPairIndex pair = setup.element_pair_of[index(distance.pair)];
    const std::uint32_t limits =
        setup.own_limits.empty() ? 0 : setup.checked[setup.element_pairs[pair].link_pair].limits;
    if (!(distance.measured.distance <= work.distances[limits]) || !isRefinable(setup, pair)) {
      continue;
    }
    if (work.task_of[pair] == kNone) {
      work.task_of[pair] = static_cast<std::uint32_t>(work.tasks.size());
      work.tasks.push_back(
          {pair, i, distance.measured.distance, memory.starved_cycles[pair], 0, kInfinity});
    }
    RefineTask& task = work.tasks[work.task_of[pair]];
    if (distance.measured.distance < task.bound) {
      task.place = i;
      task.bound = distance.measured.distance;
    }
  }
  sortTasks(work);
}

}  // namespace collision_monitor
