// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/shape_rules.h"
#include "collision_monitor/model/urdf_reader.h"
#include "robot_options.h"

namespace collision_monitor::fit_tool {

/// The robot's URDF. Adds an error to `report` if it cannot be read.
RobotDescription readDescription(const RobotSource& source, SetupReport& report);

/// The text of a file; empty if none is asked for. Adds an error to `report` if it cannot be read.
/// @param what its name in messages: "option --srdf"
std::string readInput(const std::string& what, const std::string& path, SetupReport& report);

/// The rules; empty if none are asked for. Adds an error to `report` if they cannot be read.
DocumentText readRules(const std::string& path, SetupReport& report);

/// The text of a parameter of a running roscore. Adds an error to `report` if there is none.
/// @pre kHasRos
std::string readParameter(const std::string& name, SetupReport& report);

/// Looks package:// names up in the given folders in order, each a package or a folder of packages,
/// then where ROS_PACKAGE_PATH leads to; without ROS, also by AMENT_PREFIX_PATH. Takes other names
/// as they are. Has the monitor's limits. Defined in read_by_ros.cpp or read_without_ros.cpp.
ResourceLoader makeLoader(const RobotSource& source = {});

}  // namespace collision_monitor::fit_tool
