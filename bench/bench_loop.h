// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "support/instruction_sets.h"
#include "thread_time.h"

namespace collision_monitor::test {

/// Calls `query` with one item after another, again and again.
template <class Item, class Query>
void askInTurn(benchmark::State& state, const std::vector<Item>& items, const Query& query) {
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    benchmark::DoNotOptimize(query(items[next]));
    next = next + 1 == items.size() ? 0 : next + 1;
  }
  state.SetItemsProcessed(state.iterations());
}

/// The time of one call of `work` [ns]: median over several runs.
template <class Work>
double medianTime(const Work& work) {
  constexpr double kRun = 1e7;  // [ns]
  constexpr int kRuns = 9;
  const auto timeOfMany = [&](int calls) {
    return timeOf([&] {
      for (int i = 0; i < calls; ++i) {
        work();
      }
    });
  };
  const int calls = std::max(1, static_cast<int>(kRun / std::max(1.0, timeOfMany(1))));
  std::vector<double> times;
  for (int run = 0; run < kRuns; ++run) {
    times.push_back(timeOfMany(calls) / calls);
  }
  return medianOf(times);
}

/// Takes "--only INSTRUCTION_SET" out of a program's arguments. Batched kernels use only that set
/// while `only` lives.
/// @return false, and prints what is accepted, if this machine has no such set
inline bool takeOnly(std::vector<std::string>& arguments,
                     std::unique_ptr<OnlyInstructionSet>& only) {
  const auto option = std::find(arguments.begin(), arguments.end(), "--only");
  if (option == arguments.end()) {
    return true;
  }
  std::string accepted;
  for (const std::int64_t target : instructionSets()) {
    if (arguments.end() - option > 1 && option[1] == hwy::TargetName(target)) {
      only = std::make_unique<OnlyInstructionSet>(target);
      arguments.erase(option, option + 2);
      return true;
    }
    accepted += std::string(" ") + hwy::TargetName(target);
  }
  std::fprintf(stderr, "--only: this machine has%s\n", accepted.c_str());
  return false;
}

/// The main program of a benchmark: runs the registered benchmarks that the command line selects.
///   [--only INSTRUCTION_SET] [--benchmark_...]
inline int runBenchmarks(int argc, char** argv, void (*register_all)()) {
  benchmark::Initialize(&argc, argv);
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::unique_ptr<OnlyInstructionSet> only;
  if (!takeOnly(arguments, only)) {
    return 2;
  }
  if (!arguments.empty()) {
    std::fprintf(stderr, "unknown argument: %s\n", arguments.front().c_str());
    return 2;
  }
  register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace collision_monitor::test
