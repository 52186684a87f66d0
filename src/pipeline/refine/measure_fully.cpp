// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/measure_fully.h"

#include <algorithm>

#include "geometry/constants.h"
#include "pipeline/refine/deepen_overlaps.h"
#include "pipeline/refine/measure_task.h"

namespace collision_monitor {

bool measureFully(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                  std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept {
  constexpr double kPastBound = 1e-6;
  const Refinement all{setup, body_poses, memory, work, distances};
  RefineTask& task =
      work.tasks[work.task_of[setup.element_pair_of[index(distances.pairs[place].pair)]]];
  // Beyond its own upper bound, at which its points may still be the nearest.
  const PairDistance& bounds = distances.pairs[place];
  const bool was_skipped = !(bounds.shortfall > 0.0);
  const double beyond =
      was_skipped ? kInfinity : bounds.measured.distance + bounds.shortfall + kPastBound;
  const Goal goal{std::max(cutoffFor(all, task), beyond), budgetOf(all)};
  if (work.work_done < goal.budget) {
    const ElementDistance found = measureTask(all, task, goal, recallTask(all, task));
    if (found.has_points || found.is_complete) {
      task.place = place;
      work.refined -= work.is_measured[task.pair];  // `report` counts the pair once more
      report(all, task, found);
      deepenOverlap(all, task, goal.budget);
      return true;
    }
  }
  // Skipped elements wait for what the budget leaves, so that they starve no nearer ones.
  memory.starved_cycles[task.pair] += was_skipped ? 0 : 1;
  return false;
}

void raiseByRecall(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                   std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept {
  const Refinement all{setup, body_poses, memory, work, distances};
  PairDistance& bound = distances.pairs[place];
  const ElementDistance recalled =
      recallTask(all, work.tasks[work.task_of[setup.element_pair_of[index(bound.pair)]]]);
  if (recalled.quality == Quality::lower_bound) {
    raiseBound(recalled.measured.distance, bound);
  }
}

void placeTasks(const CycleSetup& setup, RefineWork& work,
                const PairDistances& distances) noexcept {
  for (RefineTask& task : work.tasks) {
    task.place = kNone;
    work.is_passed[task.pair] = 0;
  }
  for (std::uint32_t i = 0; i < distances.pairs.size(); ++i) {
    const PairDistance& pair = distances.pairs[i];
    const std::uint32_t task = work.task_of[setup.element_pair_of[index(pair.pair)]];
    if (task != kNone) {
      std::uint32_t& place = work.tasks[task].place;
      place = place == kNone || comesNearer(pair, distances.pairs[place]) ? i : place;
    }
  }
}

void dropOtherBodies(const CycleSetup& setup, const RefineWork& work,
                     PairDistances& distances) noexcept {
  std::vector<PairDistance>& pairs = distances.pairs;
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const ElementPairIndex elements = setup.element_pair_of[index(pairs[i].pair)];
    const std::uint32_t task = work.task_of[elements];
    if (task == kNone || work.is_passed[elements] == 0 || work.tasks[task].place == i) {
      pairs[kept++] = pairs[i];
    }
  }
  pairs.resize(kept);
}

}  // namespace collision_monitor
