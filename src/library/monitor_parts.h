// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/robot_monitor.h"
#include "pipeline/world/prepare_object.h"

namespace collision_monitor {

/// What a RobotMonitor and its queries share.
struct MonitorParts {
  CycleSetup setup;                          ///< of the robots and the objects
  std::shared_ptr<const CycleSetup> robots;  ///< without objects, as withoutPairs; null: no objects
  PreparedObjects prepared;
  MonitorOptions options;             ///< without those that are asked or told while it is made
  std::vector<Pose> world_from_root;  ///< by RobotId
  std::vector<JointVariable> variables;
  JointPositions default_state;
  std::vector<EnclosingShape> shapes;
};

/// Descriptions of robots, and those that are missing.
struct GivenRobots {
  std::vector<RobotDescription> descriptions;
  SetupReport report;  ///< a fault for each that is missing
};

/// @throws SetupError with all faults, those of the robots' report first
/// @throws Interrupted
std::shared_ptr<const MonitorParts> makeMonitorParts(const GivenRobots& robots,
                                                     const MonitorOptions& given);

/// The same robots with other objects.
/// @throws SetupError, Interrupted
std::shared_ptr<const MonitorParts> replaceWorld(const MonitorParts& former,
                                                 const DocumentText& world);

/// Fills what follows from the set-up: the poses of roots, the variables, their default state and
/// the shapes.
void describeSetup(MonitorParts& parts);

}  // namespace collision_monitor
