// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace collision_monitor::test {

/// This thread's processor time [ns], on which other programs have little effect.
inline double threadTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// The time of one call of `work` [ns].
template <class Work>
double timeOf(const Work& work) {
  const double start = threadTime();
  work();
  return threadTime() - start;
}

/// @pre there is at least one.
inline double medianOf(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

/// Median over several calls of `work` [ns].
template <class Work>
double medianTimeOf(int calls, const Work& work) {
  std::vector<double> times;
  for (int i = 0; i < calls; ++i) {
    times.push_back(timeOf(work));
  }
  return medianOf(times);
}

}  // namespace collision_monitor::test
