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
/// Launch files start nodes in any order, so this waits up to `wait_for_description` for URDF
/// parameters; not at all if the parameters have faults.
///
/// A robot of the parameter `robots` whose URDF parameter is missing then is listed as missing, if
/// another robot is there. All else that is missing or unreadable is added to `report` with the
/// name that was looked up. After a fault of the robots there are none.
/// @param report has the faults of the parameters
LoadedRobots loadDescriptions(const ros::NodeHandle& private_node, const Parameters& parameters,
                              const ResourceLoader& load_resource, SetupReport& report);

/// The same robots with those whose URDF parameters have come since. Robots that were there stay as
/// they are, also if their parameters or files have gone.
/// @param only looks for this robot alone, by its place in the list; nothing: for all
LoadedRobots loadLate(const ros::NodeHandle& private_node, const Parameters& parameters,
                      const ResourceLoader& load_resource, const LoadedRobots& former,
                      std::optional<std::size_t> only, SetupReport& report);

}  // namespace collision_monitor
