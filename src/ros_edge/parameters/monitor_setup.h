// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "geometry/interruption.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// Warnings about a set-up that are found after its monitoring began.
class LaterWarnings {
 public:
  void add(const std::vector<Problem>& warnings) {
    const std::lock_guard<std::mutex> lock(mutex_);
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  }
  std::vector<Problem> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return warnings_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Problem> warnings_;
};

using RuleEnd = std::chrono::steady_clock::time_point;
constexpr RuleEnd kLasts = RuleEnd::max();  ///< of a rule that does not end by itself

/// Everything that a reload replaces at once. The cycle and the services share it; it never
/// changes.
struct MonitorSetup {
  Parameters parameters;
  CycleSetup setup;
  std::string world_frame;
  std::vector<RobotDescription> descriptions;  ///< it was built from these
  std::vector<RuleEnd> rule_ends{};            ///< by CycleSetup::pair_rules
  std::shared_ptr<LaterWarnings> later_warnings{std::make_shared<LaterWarnings>()};
};

/// Whether both were built from the same robots: they differ by rules and limits alone, and share
/// ids of links, bodies and elements.
inline bool haveSameRobots(const MonitorSetup& one, const MonitorSetup& other) {
  return one.later_warnings == other.later_warnings;
}

/// When the last muted pair is checked again; nothing if none is muted.
std::optional<RuleEnd> lastMuteOf(const MonitorSetup& setup);

/// The topic of each robot's joint states, by RobotId; "": no topic.
std::vector<std::string> jointTopics(const MonitorSetup& setup);

/// The tf frames of the links and of the world.
std::vector<std::string> frameNames(const MonitorSetup& setup);

/// Reads parameters and descriptions again and builds the set-up. May wait for descriptions.
/// @throws SetupError with every problem of parameters, URDFs and SRDFs.
/// @throws Interrupted if `goes_on` returned false
std::shared_ptr<const MonitorSetup> makeMonitorSetup(const ros::NodeHandle& private_node,
                                                     GoesOn goes_on);

}  // namespace collision_monitor
