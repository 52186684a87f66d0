// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

#include <functional>
#include <memory>
#include <string>

#include "ros_edge/outputs/cycle_statistics.h"
#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// Cycles since the last report.
struct CycleReport {
  std::uint64_t cycles{0};
  std::uint64_t overruns{0};
  double since_newest{0.0};  ///< [s] since the newest cycle ended, in this report or before
  double longest{0.0};       ///< [s] limit of since_newest
};

/// Level and sentence of the entry `cycle`. If cycles are as slow as reports, there may be no cycle
/// between two reports.
void summarizeCycles(const CycleReport& report,
                     diagnostic_updater::DiagnosticStatusWrapper& status);

/// The entry `verdict`. All keys differ.
void describeVerdict(const CycleSummary& summary,
                     diagnostic_updater::DiagnosticStatusWrapper& status);

/// The entry `setup`. All keys differ.
void describeSetup(const MonitorSetup& setup, diagnostic_updater::DiagnosticStatusWrapper& status);

/// Publishes /diagnostics once per wall second, even while a simulated clock stands still. Five
/// entries: the verdict with its data; the cycle with its times; the budget with the pairs that use
/// most of it; the step between poses with its limits; the set-up with its warnings.
class Diagnostics {
 public:
  using SetupGetter = std::function<std::shared_ptr<const MonitorSetup>()>;

  /// @pre `statistics` outlives the diagnostics.
  Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
              const std::string& node_name, CycleStatistics& statistics, SetupGetter current_setup);

 private:
  void reportCycle(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportBudget(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportStep(diagnostic_updater::DiagnosticStatusWrapper& status);

  CycleStatistics& statistics_;
  SetupGetter current_setup_;
  diagnostic_updater::Updater updater_;
  CycleCounts last_counts_;
  StepCount last_steps_;
  ros::SteadyTime last_time_;
  ros::WallTimer timer_;
};

}  // namespace collision_monitor
