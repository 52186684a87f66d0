// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ros_edge/parameters/parameter_struct.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// Reads a valid ROS name, or none.
/// @param accepted "the name of a topic"
void readName(ParameterStruct& fields, const std::string& field, const char* accepted,
              std::string& name, SetupReport& report);

/// Reads the parameter `robots`. Robots without a name are called robot_0, robot_1, ...
/// @param where "/collision_monitor/robots"
std::vector<RobotSource> readRobotList(const XmlRpc::XmlRpcValue& values, const std::string& where,
                                       SetupReport& report);

}  // namespace collision_monitor
