// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "robot_options.h"

namespace collision_monitor::fit_tool {

/// Whether the program is built with libpng: then it has --html.
constexpr bool kHasPictures = COLLISION_MONITOR_HAS_PNG;

/// The command line. Empty names: not asked for.
struct Options {
  RobotSource source;
  std::string srdf;
  bool is_strict{false};  ///< as in RobotDescription

  FitLimits limits{SetupOptions().default_limits};  ///< as the node's
  double padding{0.0};                              ///< [m]
  std::string rules;
  std::string link_pattern;
  std::string cache;  ///< as the parameter fit_cache

  std::string yaml, new_urdf, html, spheres_yaml, spheres_srdf;
  bool may_replace{false};  ///< may overwrite existing files
  std::uint32_t sphere_level{std::numeric_limits<std::uint32_t>::max()};  ///< the leaves
  std::size_t leaves{64};
};

/// Result of the command line: run, or end with this exit code.
struct Parsed {
  Options options;
  bool is_to_run{false};
  int exit_code{0};  ///< 0 after --help; 2 for a fault, which has been printed
};

/// An option and the file that it writes.
struct OutputOption {
  const char* option;
  std::string file;
};

/// The outputs that the user asked for.
std::vector<OutputOption> outputsOf(const Options& options);

Parsed parseOptions(int argc, const char* const* argv);

}  // namespace collision_monitor::fit_tool
