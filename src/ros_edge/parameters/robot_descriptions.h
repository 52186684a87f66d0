// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// Gets each robot's URDF, and its SRDF if there is one, from the parameter server or from files.
/// Launch files start nodes in any order, so this waits up to `wait_for_description` for URDF
/// parameters. What is missing or unreadable is added to `report` with the name that was looked up.
std::vector<RobotDescription> loadDescriptions(const ros::NodeHandle& private_node,
                                               const Parameters& parameters,
                                               const ResourceLoader& load_resource,
                                               SetupReport& report);

}  // namespace collision_monitor
