// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/diagnostics.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus statusOf(const CycleReport& report) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  summarizeCycles(report, status);
  return status;
}

TEST(CycleReport, cyclesAsSlowAsReports_mayHaveNoneBetweenTwo) {
  EXPECT_EQ(statusOf({0, 0, 1.02, 2.0}).level, DiagnosticStatus::OK);
  EXPECT_EQ(statusOf({1, 0, 0.3, 2.0}).level, DiagnosticStatus::OK);
}

TEST(CycleReport, cyclesThatStayAway_areAnErrorWithTheTime) {
  const DiagnosticStatus status = statusOf({0, 0, 2.34, 2.0});
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "no cycle for 2.3 s");
}

TEST(CycleReport, overruns_areAWarning) {
  const DiagnosticStatus status = statusOf({100, 2, 0.01, 1.01});
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "2 of 100 cycles took longer than the period");
}

}  // namespace
}  // namespace collision_monitor::test
