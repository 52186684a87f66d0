// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/robot_monitor.h"

namespace collision_monitor {

/// What a RobotMonitor and its queries share.
struct MonitorParts {
  CycleSetup setup;
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
                                                     const MonitorOptions& options);

}  // namespace collision_monitor
