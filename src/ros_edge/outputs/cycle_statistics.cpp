// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/cycle_statistics.h"

#include <algorithm>
#include <utility>

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

void CycleStatistics::addCycle(double cycle_time, bool is_overrun, RealTimeState real_time) {
  const SteadyClock::time_point now = SteadyClock::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  times_[counts_.cycles % kMemory] = cycle_time;
  ++counts_.cycles;
  counts_.overruns += is_overrun ? 1 : 0;
  counts_.newest_end = now;
  counts_.real_time = real_time;
}

void CycleStatistics::setSummary(CycleSummary summary) {
  const std::lock_guard<std::mutex> lock(mutex_);
  summary_ = std::move(summary);
}

void CycleStatistics::startWork(const BudgetTally& tally) {
  const std::lock_guard<std::mutex> lock(mutex_);
  budget_use_ = tally.use;
}

void CycleStatistics::addWork(const CycleBuffers& buffers, double cycle_time, BudgetTally& tally) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_use_taken_) {
    restart(tally);
    is_use_taken_ = false;
  }
  collision_monitor::addCycle(buffers, cycle_time, tally);
  budget_use_ = tally.use;
}

CycleStatistics::Times CycleStatistics::times() const {
  std::array<double, kMemory> sorted{};
  Times times;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    sorted = times_;
    times.count = std::min<std::size_t>(counts_.cycles, kMemory);
  }
  if (times.count == 0) {
    return times;
  }
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(times.count);
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(times.count / 2);
  std::nth_element(sorted.begin(), middle, end);
  times.median = *middle;
  times.worst = *std::max_element(sorted.begin(), end);
  return times;
}

CycleCounts CycleStatistics::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

CycleSummary CycleStatistics::summary() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return summary_;
}

BudgetUse CycleStatistics::takeBudgetUse() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const BudgetUse taken = budget_use_;
  budget_use_ = {};
  budget_use_.setup = taken.setup;
  is_use_taken_ = true;
  return taken;
}

}  // namespace collision_monitor
