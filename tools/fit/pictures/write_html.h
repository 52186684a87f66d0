// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// A self-contained page: figures of the robot, then a picture and figures of each link. It is also
/// well-formed XML.
/// @param source name of the robot
/// @param progress may be empty; called before each picture
std::string writeHtml(const FittedRobot& robot, const std::string& source,
                      const FitProgress& progress);

}  // namespace collision_monitor::fit_tool
