// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ros_edge/parameters/monitor_setup.h"

/// Listed robots whose URDF has not come.
namespace collision_monitor {

/// Whether others stop for a robot because its URDF has not come.
bool isAwaited(const ListedRobot& robot);

/// Whether any robot is awaited.
bool isAnyAwaited(const MonitorSetup& setup);

/// "robot 'left' is missing: no URDF in parameter /left/robot_description (and 1 more robot)";
/// empty if none is.
std::string missingSentence(const MonitorSetup& setup);

/// The same of those that stop others.
std::string awaitedSentence(const MonitorSetup& setup);

}  // namespace collision_monitor
