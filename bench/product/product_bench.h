// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

#include "collision_monitor/pipeline/setup.h"
#include "support/robots/file_loader.h"

/// The parts of product_bench, which print one line a number, as figures/product.py reads them.
namespace collision_monitor::test {

/// check_states with the exact geometries beside FCL, times of a state, and whether the verdicts
/// agree.
void measureStates(const CycleSetup& setup);

/// Processor time of cycles at 1 kHz and at 50 Hz, and in how many a contact or the level is
/// another without a budget.
/// @param cycles at 1 kHz.
void measureCycles(const CycleSetup& setup, std::size_t cycles);

/// Processor time of check_trajectory.
void measureTrajectory(const CycleSetup& setup);

/// Time of building the set-up as the node does, without kept fits and with them, and the memory
/// that one robot takes: first of all, so that it is not what others left.
/// @return the last set-up.
CycleSetup measureStart(const RobotFile& robot);

inline void print(const std::string& name, double value, const char* unit) {
  std::printf("%s %.9g %s\n", name.c_str(), value, unit);
}

inline void print(const std::string& name, std::size_t count) {
  print(name, static_cast<double>(count), "-");
}

}  // namespace collision_monitor::test
