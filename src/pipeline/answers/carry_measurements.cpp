// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_measurements.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"

namespace collision_monitor {
namespace {

/// The elements of two links of robots, in order.
std::vector<ElementPairIndex> pairsOfRobots(const CycleSetup& setup) {
  const LinkId first_of_world = firstOfWorld(setup.model);
  std::vector<ElementPairIndex> pairs;
  for (ElementPairIndex i = 0; i < setup.element_pairs.size(); ++i) {
    if (setup.checked[setup.element_pairs[i].link_pair].b < first_of_world) {
      pairs.push_back(i);
    }
  }
  return pairs;
}

}  // namespace

std::vector<ElementPairIndex> planMeasurements(const CycleSetup& from, const CycleSetup& to,
                                               const CarryPlan& plan) {
  const std::vector<ElementPairIndex> former = pairsOfRobots(from);
  const std::vector<ElementPairIndex> now = pairsOfRobots(to);
  const bool are_same = std::equal(former.begin(), former.end(), now.begin(), now.end(),
                                   [&](ElementPairIndex before, ElementPairIndex after) {
                                     return plan.pair_of[to.element_pairs[after].link_pair] ==
                                            from.element_pairs[before].link_pair;
                                   });
  if (!are_same) {
    return {};
  }
  std::vector<ElementPairIndex> new_of(from.element_pairs.size(), kNone);
  for (std::size_t i = 0; i < former.size(); ++i) {
    new_of[former[i]] = now[i];
  }
  return new_of;
}

void carryMeasurements(const std::vector<ElementPairIndex>& new_of, CycleBuffers& former,
                       CycleBuffers& buffers) noexcept {
  buffers.memory.refined.takeRobots(former.memory.refined, new_of);
  RefineWork& work = buffers.refine;
  for (const RefineTask& task : former.refine.tasks) {
    const ElementPairIndex pair = new_of[task.pair];
    if (pair == kNone) {
      continue;
    }
    if (work.task_of[pair] == kNone) {
      work.task_of[pair] = static_cast<std::uint32_t>(work.tasks.size());
      work.tasks.push_back({pair});
    }
    work.is_measured[pair] = former.refine.is_measured[task.pair];
    buffers.memory.starved_cycles[pair] = former.memory.starved_cycles[task.pair];
  }
  work.skips_robots = false;
}

}  // namespace collision_monitor
