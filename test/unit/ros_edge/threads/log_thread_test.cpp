// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/log_thread.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/ros_edge/console.h"

namespace collision_monitor::test {
namespace {

TEST(LogThread, whileTheConsoleStands_nobodyWaitsAndTheFirstLinesAreKept) {
  constexpr std::size_t kMany = 30000;
  Console console(true);
  {
    LogThread log;
    log.warn("first");
    console.waitForFirst();
    for (std::size_t i = 0; i < kMany; ++i) {
      log.info("line " + std::to_string(i));
    }
    console.release();
  }  // waits for all lines
  const std::vector<std::string>& lines = console.lines();
  ASSERT_GT(lines.size(), 2U);
  EXPECT_EQ(lines.front(), "first");
  const std::size_t kept = lines.size() - 2;
  for (std::size_t i = 0; i < kept; ++i) {
    EXPECT_EQ(lines[1 + i], "line " + std::to_string(i));
  }
  EXPECT_LT(kept, kMany);
  EXPECT_EQ(lines.back(),
            "too much to log at once; lines left out: " + std::to_string(kMany - kept));
}

}  // namespace
}  // namespace collision_monitor::test
