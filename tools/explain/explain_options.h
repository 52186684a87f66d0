// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "robot_options.h"

namespace collision_monitor::explain_tool {

/// The command line. Empty names: not asked for.
struct Options {
  fit_tool::RobotSource source;
  std::string link_a;
  std::string link_b;
  std::string srdf;
  std::string shape_rules;
  std::string pair_rules;
  std::string world;                ///< file with objects
  std::string world_frame;          ///< empty: the root of the robot
  std::vector<std::string> limits;  ///< "warning_distance=0.1"
  std::vector<std::string> joints;  ///< "elbow=1.2"
  std::string cache;                ///< as the parameter fit_cache
};

/// Result of the command line: run, or end with this exit code.
struct Parsed {
  Options options;
  bool is_to_run{false};
  int exit_code{0};  ///< 0 after --help; 2 for a fault, which has been printed
};

Parsed parseOptions(int argc, const char* const* argv);

}  // namespace collision_monitor::explain_tool
