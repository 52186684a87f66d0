// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/startup_report.h"

#include <ros/console.h>

#include <chrono>
#include <sstream>

#include "model/object_links.h"
#include "ros_edge/outputs/pair_counts.h"
#include "ros_edge/pace.h"

namespace collision_monitor {

std::string summaryOf(const MonitorSetup& setup) {
  const std::size_t warnings = setup.setup.report.warnings.size();
  const std::size_t pairs = setup.setup.checked.size();
  const std::size_t robots = robotCount(setup.setup.model);
  const std::size_t objects = setup.world.objects.size();
  std::ostringstream text;
  text << "watching " << robots << " robot" << (robots == 1 ? "" : "s");
  if (objects > 0) {
    text << " and " << objects << (objects == 1 ? " object" : " objects");
  }
  text << " in frame '" << setup.world_frame << "': " << setup.setup.bodies.size() << " shapes, "
       << pairs << (pairs == 1 ? " pair of links, " : " pairs of links, ")
       << (setup.parameters.trigger == Trigger::pose ? "at most " : "at ")
       << 1.0 / periodOf(setup.parameters) << " Hz"
       << notCheckedText(countPairs(setup.setup.link_pairs)) << "; " << warnings
       << (warnings == 1 ? " warning" : " warnings");
  return text.str();
}

FitProgress logLongFitting() {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kBetween(3);
  return [next = Clock::now() + kBetween](const std::string& link, std::size_t done,
                                          std::size_t total) mutable {
    if (done < total && Clock::now() >= next) {
      next = Clock::now() + kBetween;
      ROS_INFO_STREAM("fitting shapes to link '" << link << "' (" << done + 1 << " of " << total
                                                 << ")");
    }
  };
}

void logSetup(const MonitorSetup& setup, LogThread& log) {
  for (const Problem& warning : setup.setup.report.warnings) {
    log.warn(toString(warning));
  }
  log.info(summaryOf(setup));
}

void logFailure(const std::exception& error) {
  std::istringstream lines(failureText(error));
  for (std::string line; std::getline(lines, line);) {
    ROS_FATAL_STREAM(line);
  }
}

}  // namespace collision_monitor
