// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/budget_use.h"

#include <algorithm>

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {
namespace {

/// A motion whose contact cannot be settled starves its pair at any budget: it does not count.
bool isShort(const CycleBuffers& buffers) noexcept {
  const SweepWork& sweep = buffers.sweep;
  return buffers.counters.left > 0 ||
         (buffers.counters.swept_left > 0 && sweep.work_done >= sweep.budget);
}

/// The work of a pair only grows, so a pair that enters `most` was not among the most before.
void rank(const PairWork& pair, std::array<PairWork, 3>& most) noexcept {
  const auto is_pair = [&](const PairWork& other) { return other.link_pair == pair.link_pair; };
  auto place = std::find_if(most.begin(), most.end(), is_pair);
  if (place == most.end()) {
    --place;
    if (!(pair.work > place->work)) {
      return;
    }
  }
  *place = pair;
  for (; place != most.begin() && place->work > (place - 1)->work; --place) {
    std::swap(*place, *(place - 1));
  }
}

void addWork(ElementPairIndex pair, std::uint32_t work, BudgetTally& tally) noexcept {
  if (work == 0) {
    return;
  }
  const LinkPairIndex link_pair = tally.use.setup->element_pairs[pair].link_pair;
  std::uint64_t& sum = tally.work_of[link_pair];
  if (sum == 0) {
    tally.counted.push_back(link_pair);
  }
  sum += work;
  rank({link_pair, sum}, tally.use.most);
}

}  // namespace

BudgetTally makeBudgetTally(const CycleSetup& setup) {
  BudgetTally tally;
  tally.use.setup = &setup;
  tally.work_of.resize(setup.checked.size(), 0);
  tally.counted.reserve(setup.checked.size());
  return tally;
}

void restart(BudgetTally& tally) noexcept {
  for (const LinkPairIndex pair : tally.counted) {
    tally.work_of[pair] = 0;
  }
  tally.counted.clear();
  const CycleSetup* setup = tally.use.setup;
  tally.use = {};
  tally.use.setup = setup;
}

void addCycle(const CycleBuffers& buffers, double time, BudgetTally& tally) noexcept {
  BudgetUse& use = tally.use;
  const std::uint64_t work = std::uint64_t{buffers.refine.work_done} + buffers.sweep.work_done;
  ++use.cycles;
  use.work += work;
  use.worst = std::max(use.worst, work);
  if (!isShort(buffers)) {
    return;
  }
  ++use.short_cycles;
  use.short_work += work;
  use.short_time += time;
  for (const RefineTask& task : buffers.refine.tasks) {
    addWork(task.pair, task.work, tally);
  }
  for (const SweepTask& task : buffers.sweep.tasks) {
    addWork(task.pair, task.work, tally);
  }
}

}  // namespace collision_monitor
