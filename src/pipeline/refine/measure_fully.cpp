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

std::uint32_t placeOfNearest(const CycleSetup& setup, const PairDistances& distances,
                             std::uint32_t place) noexcept {
  const ElementPairIndex elements = setup.element_pair_of[index(distances.pairs[place].pair)];
  std::uint32_t nearest = place;
  for (std::uint32_t i = 0; i < distances.pairs.size(); ++i) {
    const PairDistance& pair = distances.pairs[i];
    if (setup.element_pair_of[index(pair.pair)] == elements && pair.quality != Quality::unknown &&
        comesNearer(pair, distances.pairs[nearest])) {
      nearest = i;
    }
  }
  return nearest;
}

void markOtherBodies(const CycleSetup& setup, std::uint32_t place,
                     PairDistances& distances) noexcept {
  const ElementPairIndex elements = setup.element_pair_of[index(distances.pairs[place].pair)];
  for (std::uint32_t i = 0; i < distances.pairs.size(); ++i) {
    if (i != place && setup.element_pair_of[index(distances.pairs[i].pair)] == elements) {
      distances.pairs[i].quality = Quality::unknown;
    }
  }
}

void dropMarked(PairDistances& distances) noexcept {
  const auto isMarked = [](const PairDistance& pair) { return pair.quality == Quality::unknown; };
  std::vector<PairDistance>& pairs = distances.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isMarked), pairs.end());
}

}  // namespace collision_monitor
