// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace collision_monitor::fit_tool {

/// Whether the programs are built with ROS: then they read parameters and fetch meshes by http.
constexpr bool kHasRos = COLLISION_MONITOR_HAS_ROS;

/// The source of a program's robot. Empty names: not asked for.
struct RobotSource {
  std::string urdf;       ///< file, or "-" for standard input
  std::string parameter;  ///< alternative to the file; needs ROS
  std::vector<std::string> package_roots;
  std::vector<std::string> schemes;  ///< as LoadRules::schemes; needs ROS
};

constexpr int kUsageFault = 2;  ///< exit code

void addRobotOptions(CLI::App& app, RobotSource& source);

/// @throws CLI::ValidationError unless exactly one robot is given.
void checkOneRobot(const RobotSource& source);

/// An input file and its description for the user.
struct InputFile {
  const char* what;
  const std::string& path;
};

/// @throws CLI::ValidationError if the option would overwrite the input file, even under another
/// name.
void checkKeeps(const InputFile& input, const std::string& option, const std::string& output);

/// --force
void addForceOption(CLI::App& app, bool& may_replace);

/// @param has_none set by --no-cache: the cache is "none"
void addCacheOptions(CLI::App& app, std::string& cache, bool& has_none);

}  // namespace collision_monitor::fit_tool
