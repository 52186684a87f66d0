// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace collision_monitor::fit_tool {

/// Where a program's robot comes from. Empty names mean: not asked for.
struct RobotSource {
  std::string urdf;       ///< file, or "-" for standard input
  std::string parameter;  ///< in place of the file
  std::vector<std::string> package_roots;
  std::vector<std::string> schemes;  ///< as LoadRules::schemes
};

constexpr int kUsageFault = 2;  ///< exit code

void addRobotOptions(CLI::App& app, RobotSource& source);

/// @throws CLI::ValidationError unless there is one robot.
void checkOneRobot(const RobotSource& source);

/// A file that is read, and what it is to the user.
struct InputFile {
  const char* what;
  const std::string& path;
};

/// @throws CLI::ValidationError if what the option writes is that file, whatever the two are
/// called.
void checkKeeps(const InputFile& input, const std::string& option, const std::string& output);

/// --force
void addForceOption(CLI::App& app, bool& may_replace);

/// @param has_none --no-cache: a cache of "none"
void addCacheOptions(CLI::App& app, std::string& cache, bool& has_none);

}  // namespace collision_monitor::fit_tool
