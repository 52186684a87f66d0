// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/all_cores.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

TEST(ForEachOnAllCores, everyJob_isDoneOnce) {
  std::vector<std::atomic<int>> calls(1000);
  forEachOnAllCores(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) {
    EXPECT_EQ(count, 1);
  }
  forEachOnAllCores(0, [](std::size_t) { FAIL(); });
}

TEST(ForEachOnAllCores, ofSeveralFaults_thatOfTheFirstJobIsThrown) {
  std::atomic<int> calls{0};
  try {
    forEachOnAllCores(100, [&](std::size_t i) {
      ++calls;
      if (i % 10 == 7) {
        throw std::runtime_error(std::to_string(i));
      }
    });
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_STREQ(fault.what(), "7");
  }
  EXPECT_EQ(calls, 100);
}

TEST(ForEachOnAllCores, jobs_askWhatTheirCallerAsks_andEndWithIt) {
  int asked = 0;
  const Interruptible interruptible([&] { return ++asked <= 50; });
  const auto ask = [](std::size_t) { throwIfInterrupted(); };
  forEachOnAllCores(50, ask);
  EXPECT_EQ(asked, 50);
  EXPECT_THROW(forEachOnAllCores(50, ask), Interrupted);
  EXPECT_EQ(asked, 51);
}

}  // namespace
}  // namespace collision_monitor
