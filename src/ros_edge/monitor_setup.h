// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

#include "collision_monitor/geometry/interruption.h"
#include "collision_monitor/pipeline/setup.h"
#include "collision_monitor/ros_edge/parameters.h"

namespace collision_monitor {

/// All that a reload replaces at once; shared by the cycle and the services, never changed.
struct MonitorSetup {
  Parameters parameters;
  CycleSetup setup;
  std::string world_frame;
};

/// The topic of each robot's joint states, by RobotId; "": none.
std::vector<std::string> jointTopics(const MonitorSetup& setup);

/// The frames of tf that hold the links, and that of the world.
std::vector<std::string> frameNames(const MonitorSetup& setup);

/// Reads parameters and descriptions anew and builds the set-up. May wait for descriptions.
/// @throws SetupError with every problem of parameters, URDFs and SRDFs.
/// @throws Interrupted where `goes_on` said no
std::shared_ptr<const MonitorSetup> makeMonitorSetup(const ros::NodeHandle& private_node,
                                                     GoesOn goes_on);

}  // namespace collision_monitor
