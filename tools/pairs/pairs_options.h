// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/pipeline/search_pairs.h"
#include "robot_options.h"
#include "several_robots.h"

namespace collision_monitor::pairs_tool {

/// The command line. Empty names: not asked for.
struct Options {
  fit_tool::RobotSource source;
  SeveralRobots robots;
  std::string cache;  ///< as the parameter fit_cache
  PairSearchOptions search;
  std::string check;        ///< an SRDF to be held against what is found
  std::string write_srdf;   ///< updated if it exists
  std::string write_yaml;   ///< never updated
  bool may_replace{false};  ///< write files anew
  bool trusts_samples{false};
};

/// Result of the command line: run, or end with this exit code.
struct Parsed {
  Options options;
  bool is_to_run{false};
  int exit_code{0};  ///< 0 after --help; 2 for a fault, which has been printed
};

Parsed parseOptions(int argc, const char* const* argv);

}  // namespace collision_monitor::pairs_tool
