// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "product_bench.h"
#include "thread_time.h"

namespace collision_monitor::test {

/// Prints a peer's time of one state [us]. Some queries take seconds: these are timed once, or for
/// some of the states.
/// @param query of the state with this number
template <class Query>
void timePeer(const std::string& name, std::size_t states, const Query& query) {
  constexpr double kLong = 2e9;    // [ns]
  constexpr double kEnough = 2e9;  // [ns]
  constexpr std::size_t kLeast = 5;
  std::vector<double> times;
  std::size_t asked = 0;
  for (int run = 0;
       run < 3 && (times.empty() || times.back() * 1e3 * static_cast<double>(states) < kLong);
       ++run) {
    const double start = threadTime();
    double taken = 0.0;
    for (asked = 0; asked < states && (asked < kLeast || taken < kEnough); ++asked) {
      query(asked);
      taken = threadTime() - start;
    }
    times.push_back(1e-3 * taken / static_cast<double>(asked));
  }
  print(name, medianOf(times), "us");
  print(name + "_states", asked);
}

}  // namespace collision_monitor::test
