// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/shape_rules.h"
#include "collision_monitor/model/urdf_reader.h"
#include "robot_options.h"

namespace collision_monitor::fit_tool {

/// The robot's URDF. What cannot be read is added to `report`.
RobotDescription readDescription(const RobotSource& source, SetupReport& report);

/// The text of a file; empty where none is asked for. What cannot be read is added to `report`.
/// @param what messages call it: "option --srdf"
std::string readInput(const std::string& what, const std::string& path, SetupReport& report);

/// The rules; empty where none are asked for. A file that cannot be read is added to `report`.
ShapeRulesText readRules(const std::string& path, SetupReport& report);

/// Looks for package:// names in folders that hold packages or are one, in their order, then where
/// ROS does; takes other names as they are. Limits are those of the monitor.
ResourceLoader makeLoader(const RobotSource& source);

}  // namespace collision_monitor::fit_tool
