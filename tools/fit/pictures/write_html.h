// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// Escapes text for HTML and XML, between tags and in attributes. Control characters are not
/// allowed there and become question marks.
std::string escaped(const std::string& text);

/// Source: RFC 4648, section 4.
std::string base64Of(const std::string& bytes);

/// A self-contained page: figures of the robot, then a picture and figures of each link. It is also
/// well-formed XML.
/// @param source name of the robot
/// @param progress may be empty; called before each picture
std::string writeHtml(const FittedRobot& robot, const std::string& source,
                      const FitProgress& progress);

}  // namespace collision_monitor::fit_tool
