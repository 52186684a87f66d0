// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// Fetches the URDF, and the SRDF if there is one, of each robot from the parameter server
/// or from files. Waits up to `wait_for_description` for URDF parameters that are not there
/// yet, as launch files start nodes in no order. What is missing or unreadable is added to
/// `report` with the name that was looked up.
std::vector<RobotDescription> loadDescriptions(const ros::NodeHandle& private_node,
                                               const Parameters& parameters,
                                               const ResourceLoader& load_resource,
                                               SetupReport& report);

}  // namespace collision_monitor
