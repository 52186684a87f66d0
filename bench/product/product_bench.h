// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

#include "collision_monitor/pipeline/setup.h"
#include "support/robots/file_loader.h"

/// The parts of product_bench. They print one line per number, which figures/product.py reads.
namespace collision_monitor::test {

/// check_states with the exact geometries beside FCL: times per state, and whether verdicts agree.
void measureStates(const CycleSetup& setup);

/// Processor time of cycles at 1 kHz and at 50 Hz, and the number of cycles in which a contact or
/// the level differs without a budget.
/// @param cycles at 1 kHz.
void measureCycles(const CycleSetup& setup, std::size_t cycles);

/// Processor time of check_trajectory.
void measureTrajectory(const CycleSetup& setup);

/// Time of building the set-up as the node does, without and with a fit cache, and the memory of
/// one robot. Runs first, so that it does not count the memory of other parts.
/// @return the last set-up.
CycleSetup measureStart(const RobotFile& robot);

inline void print(const std::string& name, double value, const char* unit) {
  std::printf("%s %.9g %s\n", name.c_str(), value, unit);
}

inline void print(const std::string& name, std::size_t count) {
  print(name, static_cast<double>(count), "-");
}

}  // namespace collision_monitor::test
