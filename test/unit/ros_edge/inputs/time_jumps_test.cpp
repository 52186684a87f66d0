// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/time_jumps.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

SteadyClock::time_point wallTime(double seconds) {
  return SteadyClock::time_point(
      std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(seconds)));
}

const char* const kOneJump = "time jumped back; poses are unknown until new transforms come";

TEST(TimeJumps, jumpsFarApart_areEachTold) {
  TimeJumps jumps;
  EXPECT_EQ(jumps.tell(wallTime(100.0)), kOneJump);
  EXPECT_EQ(jumps.tell(wallTime(110.0)), kOneJump);
}

TEST(TimeJumps, fiftyASecond_areALineInTenSecondsThatSuspectsTwoClocks) {
  TimeJumps jumps;
  int lines = 0;
  std::string last;
  for (int i = 0; i <= 1000; ++i) {
    const std::string line = jumps.tell(wallTime(100.0 + 0.02 * i));
    lines += line.empty() ? 0 : 1;
    last = line.empty() ? last : line;
  }
  EXPECT_EQ(lines, 3);
  EXPECT_NE(last.find("again and again (500 times"), std::string::npos) << last;
  EXPECT_NE(last.find("two nodes may publish /clock"), std::string::npos) << last;
}

}  // namespace
}  // namespace collision_monitor::test
