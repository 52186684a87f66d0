// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/refine_tasks.h"

#include <algorithm>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// False for two bodies that are their elements: their distance is already that of the elements.
bool isRefinable(const CycleSetup& setup, const PairMemory& memory, const RefineWork& work,
                 ElementPairIndex pair) noexcept {
  if (work.skips_robots && !memory.refined.isOfObject(pair)) {
    return false;
  }
  const ElementPair& elements = setup.element_pairs[pair];
  return !setup.elements[index(elements.a)].is_body || !setup.elements[index(elements.b)].is_body;
}

/// Forgets the last cycle but for the order of its tasks, which is nearly the next one.
void forgetLastCycle(const CycleSetup& setup, RefineWork& work) noexcept {
  for (RefineTask& task : work.tasks) {
    work.is_measured[task.pair] = 0;
    work.nearest[setup.element_pairs[task.pair].link_pair] = kInfinity;
    task = {task.pair};
  }
  work.refined = work.left = 0;
  work.work_done = work.work_before;
}

/// Drops the tasks of pairs that are no longer near.
void dropFar(RefineWork& work) noexcept {
  const auto isFar = [&](const RefineTask& task) {
    const bool is_far = task.place == kNone;
    work.task_of[task.pair] = is_far ? kNone : work.task_of[task.pair];
    return is_far;
  };
  work.tasks.erase(std::remove_if(work.tasks.begin(), work.tasks.end(), isFar), work.tasks.end());
}

bool comesFirst(const RefineTask& x, const RefineTask& y) noexcept {
  return std::tie(y.starved_cycles, x.bound, x.pair) < std::tie(x.starved_cycles, y.bound, y.pair);
}

void sortTasks(RefineWork& work) noexcept {
  std::sort(work.tasks.begin(), work.tasks.end(), comesFirst);
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
    if (!(distance.measured.distance <= work.distances[limits]) ||
        !isRefinable(setup, memory, work, pair)) {
      continue;
    }
    if (work.task_of[pair] == kNone) {
      work.task_of[pair] = static_cast<std::uint32_t>(work.tasks.size());
      work.tasks.push_back({pair});
    }
    RefineTask& task = work.tasks[work.task_of[pair]];
    task.starved_cycles = memory.starved_cycles[pair];
    if (task.place == kNone || distance.measured.distance < task.bound) {
      task.place = i;
      task.bound = distance.measured.distance;
    }
  }
  dropFar(work);
  sortTasks(work);
}

}  // namespace collision_monitor
