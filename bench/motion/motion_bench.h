// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <ctime>
#include <string>

#include "thread_time.h"

/// The parts of motion_bench. They print one line per number, which figures/motion.py reads.
namespace collision_monitor::test {

/// @param passes plates that pass beside a small plate or cross it.
/// @param looked_through crossings of which every step is measured.
void runCrossings(int crossings, int passes, int looked_through);

/// @param part FCL's samples are taken between every `part`-th way-point and the next.
/// @return the program's exit code.
int runTrajectory(const std::string& robot, std::size_t part);

inline void print(const char* name, double value) { std::printf("%s %.9g\n", name, value); }

/// Processor time, so that other programs do not count.
inline double millisecondsSince(std::clock_t start) {
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// [ms] Median of several runs.
template <class Run>
double medianMilliseconds(int runs, const Run& run) {
  return 1e-6 * medianTimeOf(runs, run);
}

}  // namespace collision_monitor::test
