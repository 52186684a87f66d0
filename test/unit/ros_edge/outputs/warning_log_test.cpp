// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/warning_log.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/ros_edge/console.h"

namespace collision_monitor::test {
namespace {

const ros::SteadyTime kNow(100.0);

PairWarning warningOf(const std::string& link_a, std::uint8_t after) {
  PairWarning warning;
  warning.pair.link_a = link_a;
  warning.pair.link_b = "torso";
  warning.after = after;
  warning.sentence = link_a + " and torso";
  return warning;
}

/// As when an object comes and goes: its pairs are others each time.
TEST(WarningLog, aVerdictOfAPair_isLoggedOnceASecondAcrossSetups) {
  Console console;
  {
    LogThread thread;
    WarningLog log(thread);
    for (int i = 0; i < 3; ++i) {
      log.startWatch();
      log.logChange(warningOf("hand", PairWarning::CONTACT), kNow);
      log.logChange(warningOf("hand", PairWarning::CLEAR), kNow);
      log.logChange(warningOf("elbow", PairWarning::CONTACT), kNow);
    }
  }  // waits for all lines
  EXPECT_EQ(console.lines(),
            (std::vector<std::string>{"contact: hand and torso", "clear: hand and torso",
                                      "contact: elbow and torso"}));
}

/// As when the joint states of a robot with hundreds of pairs stop.
TEST(WarningLog, manyVerdictsAtOnce_areCountedButForContacts) {
  Console console;
  {
    LogThread thread;
    WarningLog log(thread);
    for (int i = 0; i < 30; ++i) {
      log.logChange(warningOf("link_" + std::to_string(i), PairWarning::UNKNOWN), kNow);
    }
    log.logChange(warningOf("hand", PairWarning::CONTACT), kNow);
    log.logChange(warningOf("elbow", PairWarning::CLEAR), kNow + ros::WallDuration(1.1));
  }
  const std::vector<std::string> lines = console.lines();
  ASSERT_EQ(lines.size(), 23U);
  EXPECT_EQ(lines[19], "unknown: link_19 and torso");
  EXPECT_EQ(lines[20], "contact: hand and torso");
  EXPECT_EQ(lines[21],
            "and 10 more changes of pairs within a second, which the topic `warnings` has");
  EXPECT_EQ(lines[22], "clear: elbow and torso");
}

}  // namespace
}  // namespace collision_monitor::test
