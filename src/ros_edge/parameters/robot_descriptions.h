// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// The robots that the parameters list, and the descriptions of those that are there, in the same
/// order.
struct LoadedRobots {
  std::vector<RobotDescription> descriptions;
  std::vector<ListedRobot> listed;
};

/// Gets each robot's URDF, and its SRDF if there is one, from the parameter server or from files.
/// Launch files start nodes in any order, so this waits up to `patience` [s] for URDF parameters.
///
/// A robot of the parameter `robots` whose URDF parameter is missing then is listed as missing, if
/// another robot is there. All else that is missing or unreadable is added to `report` with the
/// name that was looked up.
LoadedRobots loadDescriptions(const ros::NodeHandle& private_node, const Parameters& parameters,
                              const ResourceLoader& load_resource, double patience,
                              SetupReport& report);

/// The same robots with those whose URDF parameters have come since. Robots that were there stay as
/// they are, also if their parameters or files have gone.
/// @param only looks for this robot alone, by its place in the list; nothing: for all
LoadedRobots loadLate(const ros::NodeHandle& private_node, const Parameters& parameters,
                      const ResourceLoader& load_resource, const LoadedRobots& former,
                      std::optional<std::size_t> only, SetupReport& report);

}  // namespace collision_monitor
