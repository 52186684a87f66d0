// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// Text that may stand between tags and in attributes of HTML and XML. Control characters, which
/// neither may hold, become question marks.
std::string escaped(const std::string& text);

/// RFC 4648, section 4.
std::string base64Of(const std::string& bytes);

/// One page that needs no other file: figures of the robot, then a picture and figures of each
/// link. It is well-formed XML too.
/// @param source what the robot is called
/// @param progress may be empty; called before each picture
std::string writeHtml(const FittedRobot& robot, const std::string& source,
                      const FitProgress& progress);

}  // namespace collision_monitor::fit_tool
