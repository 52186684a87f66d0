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

#include "collision_monitor/model/world.h"
#include "collision_monitor/pipeline/setup.h"
#include "geometry/interruption.h"
#include "pipeline/world/prepare_object.h"
#include "ros_edge/markers/object_mesh.h"
#include "ros_edge/parameters/parameters.h"
#include "ros_edge/parameters/robot_descriptions.h"

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
  std::shared_ptr<const CycleSetup> robots;  ///< without objects, as withoutPairs
  std::vector<ListedRobot> listed;           ///< in the order of the parameter `robots`
  World world;
  /// Objects of the parameters that are attached to links of missing robots.
  std::vector<WorldObject> held_back;
  PreparedObjects prepared;  ///< of `world`
  DrawnMeshes drawn;         ///< of `world`, for markers
  CycleSetup setup;          ///< of the robots and the world
  std::string world_frame;
  std::vector<RobotDescription> descriptions;  ///< it was built from these
  std::vector<RuleEnd> rule_ends{};            ///< by CycleSetup::pair_rules
  std::shared_ptr<LaterWarnings> later_warnings{std::make_shared<LaterWarnings>()};
};

/// All parts of a set-up but `setup` and `rule_ends`, for one that follows it.
std::shared_ptr<MonitorSetup> partsOf(const MonitorSetup& former);

/// When the last muted pair is checked again; nothing if none is muted.
std::optional<RuleEnd> lastMuteOf(const MonitorSetup& setup);

/// The topic of each robot's joint states, by RobotId; "": no topic.
std::vector<std::string> jointTopics(const MonitorSetup& setup);

/// The tf frames of the links, of the objects and of the world.
std::vector<std::string> frameNames(const MonitorSetup& setup);

/// Reads parameters and descriptions again and builds the set-up. May wait for descriptions.
/// @param former keeps its objects, in place of those of the parameters; may be null
/// @throws SetupError with every problem of parameters, URDFs, SRDFs and objects.
/// @throws Interrupted if `goes_on` returned false
std::shared_ptr<const MonitorSetup> makeMonitorSetup(const ros::NodeHandle& private_node,
                                                     GoesOn goes_on, const MonitorSetup* former);

/// Whether the URDF of a listed robot has not come yet.
bool isAnyMissing(const MonitorSetup& setup);

/// Reads and fits robots that have come, which may take long.
/// @param come those of `former`, and others
/// @param report has the faults of loading them
/// @return robots, listed and descriptions, for takeIn
/// @throws SetupError with every problem of these robots
/// @throws Interrupted
std::shared_ptr<const MonitorSetup> buildLate(LoadedRobots come, const MonitorSetup& former,
                                              SetupReport& report);

/// The same set-up with the robots that buildLate made beside its own. Objects, rules and limits
/// stay as they are; objects that were held back are added where their links are there now.
/// @throws SetupError with every problem of rules and objects beside these robots
/// @throws Interrupted
std::shared_ptr<const MonitorSetup> takeIn(const MonitorSetup& late, const MonitorSetup& former);

/// The same set-up that tells other reasons why robots are missing.
/// @param listed the same robots; of those that are missing, `missing` and `has_come` count
std::shared_ptr<const MonitorSetup> withMissing(const MonitorSetup& former,
                                                const std::vector<ListedRobot>& listed);

/// The same robots with another world.
/// @throws SetupError if there are more pairs than memory has room for
/// @throws Interrupted
/// @param held_back as in MonitorSetup
std::shared_ptr<const MonitorSetup> changeWorld(const MonitorSetup& former, const World& world,
                                                std::vector<WorldObject> held_back);

}  // namespace collision_monitor
