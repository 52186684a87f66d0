// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/diagnostics.h"

#include <collision_monitor/State.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/object_links.h"
#include "ros_edge/numbered_values.h"
#include "ros_edge/outputs/budget_report.h"
#include "ros_edge/outputs/pair_counts.h"

namespace collision_monitor {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace {

constexpr double kReportPeriod = 1.0;  // [s]

std::string realTimeText(RealTimeState state, int priority) {
  switch (state) {
    case RealTimeState::off:
      return "none";
    case RealTimeState::on:
      return std::to_string(priority);
    case RealTimeState::refused:
      return "not permitted";
    case RealTimeState::given_up:
      return "given up: too many late cycles";
  }
  return "";
}

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                         const std::string& node_name, CycleStatistics& statistics,
                         SetupGetter current_setup)
    : statistics_(statistics),
      current_setup_(std::move(current_setup)),
      updater_(node, private_node, node_name),
      last_time_(ros::SteadyTime::now()) {
  updater_.setHardwareID("none");
  updater_.add("verdict", [this](DiagnosticStatusWrapper& status) {
    describeVerdict(statistics_.summary(), status);
  });
  updater_.add("cycle", [this](DiagnosticStatusWrapper& status) { reportCycle(status); });
  updater_.add("budget", [this](DiagnosticStatusWrapper& status) { reportBudget(status); });
  updater_.add("step", [this](DiagnosticStatusWrapper& status) { reportStep(status); });
  updater_.add("setup", [this](DiagnosticStatusWrapper& status) {
    describeSetup(*current_setup_(), status);
  });
  timer_ =
      private_node.createWallTimer(ros::WallDuration(kReportPeriod),
                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void describeVerdict(const CycleSummary& summary, DiagnosticStatusWrapper& status) {
  // Finding a contact means that the monitor works and the robot is in trouble. Still, a reader of
  // diagnostics wants to see it in red.
  std::uint8_t level = DiagnosticStatus::OK;
  if (summary.level == State::CONTACT || summary.level == State::UNKNOWN) {
    level = DiagnosticStatus::ERROR;
  } else if (summary.level == State::WARNING || summary.muted > 0) {
    level = DiagnosticStatus::WARN;
  }
  status.summary(level, summary.sentence);
  status.add("age of the oldest known link [s]", summary.age);
  status.add("least time to contact [s]", summary.time_to_contact);
  status.add("speed scale", summary.speed_scale);
  status.add("inputs refused as too long or too many", summary.refused);
  status.add("muted pairs of links", summary.muted);
  status.add("muted for another [s]", summary.muted_for);
  for (const RobotState& robot : summary.robots) {
    status.add("robot " + robot.name + ": speed scale", robot.speed_scale);
    status.add("robot " + robot.name, robot.sentence);
  }
  status.add("unknown links", summary.unknown_links.size());
  addNumbered("unknown link", summary.unknown_links, status);
}

void summarizeCycles(const CycleReport& report, DiagnosticStatusWrapper& status) {
  if (report.since_newest > report.longest) {
    status.summaryf(DiagnosticStatus::ERROR, "no cycle for %.1f s", report.since_newest);
  } else if (report.overruns > 0) {
    status.summaryf(DiagnosticStatus::WARN, "%llu of %llu cycles took longer than the period",
                    static_cast<unsigned long long>(report.overruns),
                    static_cast<unsigned long long>(report.cycles));
  } else {
    status.summary(DiagnosticStatus::OK, "cycles keep their period");
  }
}

void Diagnostics::reportCycle(DiagnosticStatusWrapper& status) {
  const CycleSummary summary = statistics_.summary();
  const CycleStatistics::Times times = statistics_.times();
  const CycleCounts counts = statistics_.counts();
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double elapsed = (now - last_time_).toSec();
  CycleReport report;
  report.cycles = counts.cycles - last_counts_.cycles;
  report.overruns = counts.overruns - last_counts_.overruns;
  report.since_newest =
      std::chrono::duration<double>(SteadyClock::now() - counts.newest_end).count();
  report.longest = kReportPeriod + longestPeriodOf(current_setup_()->parameters);
  summarizeCycles(report, status);
  status.add("frequency [Hz]", elapsed > 0.0 ? static_cast<double>(report.cycles) / elapsed : 0.0);
  status.add("cycle time, median [us]", 1e6 * times.median);
  status.add("cycle time, worst of the last " + std::to_string(times.count) + " [us]",
             1e6 * times.worst);
  status.add("cycles", counts.cycles);
  status.add("overruns", counts.overruns);
  status.add("real-time priority",
             realTimeText(counts.real_time, current_setup_()->parameters.real_time_priority));
  status.add("pairs of shapes", summary.pairs);
  status.add("candidates", summary.candidates);
  status.add("measured", summary.measured);
  status.add("refined", summary.refined);
  status.add("left by the refine budget", summary.left);
  status.add("followed between cycles", summary.swept);
  last_time_ = now;
  last_counts_ = counts;
}

/// Gets the set-up first: while this holds it, no other one can have its address.
void Diagnostics::reportBudget(DiagnosticStatusWrapper& status) {
  const std::shared_ptr<const MonitorSetup> setup = current_setup_();
  describeBudget(*setup, statistics_.takeBudgetUse(), status);
}

/// A step over the cap is a warning unless continuous checks cover it. Then it is reported at level
/// OK; otherwise fast robots with thin links would always be yellow.
void Diagnostics::reportStep(DiagnosticStatusWrapper& status) {
  const CycleSummary summary = statistics_.summary();
  const std::uint64_t over_cap = summary.steps.over_cap - last_steps_.over_cap;
  const std::uint64_t too_long = summary.steps.too_long - last_steps_.too_long;
  if (over_cap + too_long == 0) {
    status.summary(DiagnosticStatus::OK, "poses come often enough");
  } else {
    status.summary(too_long > 0 ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                   summary.step_warning.empty() ? "some poses came too late; none of the last ones"
                                                : summary.step_warning);
  }
  status.add("step between poses [ms]", 1e3 * summary.step);
  status.add("cap on the step: thinnest shapes by their speed [ms]", 1e3 * summary.step_cap);
  status.add("steps over the cap since the last report", over_cap);
  status.add("longest step in which no link can pass another unseen [ms]",
             1e3 * summary.step_limit);
  status.add("steps longer than that since the last report", too_long);
  last_steps_ = summary.steps;
}

void describeSetup(const MonitorSetup& setup, DiagnosticStatusWrapper& status) {
  const CycleSetup& cycle = setup.setup;
  std::vector<Problem> warnings = cycle.report.warnings;
  const std::vector<Problem> later = setup.later_warnings->all();
  warnings.insert(warnings.end(), later.begin(), later.end());
  if (warnings.empty()) {
    status.summary(DiagnosticStatus::OK, "no warnings");
  } else {
    status.summary(DiagnosticStatus::WARN, std::to_string(warnings.size()) + " warning" +
                                               (warnings.size() == 1 ? "" : "s"));
  }
  status.add("robots", robotCount(cycle.model));
  status.add("objects", setup.world.objects.size());
  status.add("shapes", cycle.bodies.size());
  status.add("shapes not proven to enclose",
             std::count_if(cycle.labels.begin(), cycle.labels.end(),
                           [](const BodyLabel& label) { return !label.is_proven; }));
  status.add(
      "links without shapes",
      std::count_if(cycle.model.links.begin(), cycle.model.links.end(), [&](const Link& link) {
        return !hasShapes(link) && !cycle.model.robots[index(link.robot)].is_world;
      }));
  status.add("checked pairs of links", cycle.checked.size());
  const PairCounts counts = countPairs(cycle.link_pairs);
  for (const PairReason reason : kReasonsNotToCheck) {
    status.add(std::string("pairs of links not checked, ") + whyNotText(reason),
               countOf(reason, counts));
  }
  status.add("world frame", setup.world_frame);
  std::vector<std::string> texts;
  std::transform(warnings.begin(), warnings.end(), std::back_inserter(texts),
                 [](const Problem& warning) { return toString(warning); });
  addNumbered("warning", texts, status);
}

}  // namespace collision_monitor
