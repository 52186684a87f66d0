// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/diagnostics.h"

#include <gtest/gtest.h>

#include "status_values.h"
#include "unit/ros_edge/edge_scene.h"

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

TEST(DiagnosticVerdict, everyUnknownLinkHasAKeyOfItsOwn) {
  CycleSummary summary;
  summary.unknown_links = {"hand (stale)", "foot (missing)"};
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeVerdict(summary, status);
  const auto values = valuesOf(status);
  EXPECT_EQ(values.at("unknown links"), "2");
  EXPECT_EQ(values.at("unknown link 1"), "hand (stale)");
  EXPECT_EQ(values.at("unknown link 2"), "foot (missing)");
}

TEST(DiagnosticSetup, everyWarningHasAKeyOfItsOwn) {
  MonitorSetup setup = *slidingSetup();
  setup.setup.report.warnings = {{"a", "b", "c"}, {"d", "e", "f"}};
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeSetup(setup, status);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "2 warnings");
  const auto values = valuesOf(status);
  EXPECT_EQ(values.at("warning 1"), "a: b; accepted: c");
  EXPECT_EQ(values.at("warning 2"), "d: e; accepted: f");
}

TEST(DiagnosticSetup, framesWithoutGeometry_areNoWarning_andCounted) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeSetup(*slidingSetup(), status);  // with an antenna
  EXPECT_EQ(status.level, DiagnosticStatus::OK) << status.message;
  EXPECT_EQ(valuesOf(status).at("links without shapes"), "1");
}

TEST(DiagnosticSetup, pairsThatAreNotChecked_areCountedByReason) {
  SetupOptions options;
  options.ignored_pairs = {{"base", "tool"}};
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeSetup(*slidingSetup(options), status);
  auto values = valuesOf(status);
  EXPECT_EQ(values["checked pairs of links"], "2");
  EXPECT_EQ(values["pairs of links not checked, hidden by ignore_pairs"], "1");
  EXPECT_EQ(values["pairs of links not checked, that meet at a joint"], "3");
}

}  // namespace
}  // namespace collision_monitor::test
