// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

#include "collision_monitor/pipeline/setup.h"

/// The parts of product_bench, which print one line a number, as figures/product.py reads them.
namespace collision_monitor::test {

/// check_states with the exact geometries beside FCL, times of a state, and whether the verdicts
/// agree.
void measureStates(const CycleSetup& setup);

inline void print(const std::string& name, double value, const char* unit) {
  std::printf("%s %.9g %s\n", name.c_str(), value, unit);
}

inline void print(const std::string& name, std::size_t count) {
  print(name, static_cast<double>(count), "-");
}

}  // namespace collision_monitor::test
