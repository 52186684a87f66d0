// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>

namespace collision_monitor::fit_tool {

namespace {

const char* const kInput = "Input";

void addRosOptions(CLI::App& app, RobotSource& source) {
  app.add_option("--param", source.parameter,
                 "read the URDF from this parameter of a running roscore instead")
      ->type_name("NAME")
      ->group(kInput);
  app.add_option("--scheme", source.schemes,
                 "by which meshes may be fetched, as http; may be given several times;\n"
                 "without it only files and packages are read")
      ->allow_extra_args(false)
      ->type_name("NAME")
      ->group(kInput);
}

}  // namespace

void addRobotOptions(CLI::App& app, RobotSource& source) {
  app.add_option("urdf", source.urdf, "the robot, or - for standard input")->type_name("FILE");
  app.add_option("--package-root", source.package_roots,
                 "holds packages, or is one: where package:// names are looked up first,\n"
                 "before ROS_PACKAGE_PATH; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FOLDER")
      ->group(kInput);
  if (kHasRos) {
    addRosOptions(app, source);
  }
}

void checkOneRobot(const RobotSource& source) {
  if (source.urdf.empty() == source.parameter.empty()) {
    throw CLI::ValidationError(kHasRos ? "give one robot: a URDF file, - or --param NAME"
                                       : "give one robot: a URDF file or -");
  }
}

void checkKeeps(const InputFile& input, const std::string& option, const std::string& output) {
  std::error_code is_not_there;
  if (!output.empty() &&
      (output == input.path || std::filesystem::equivalent(output, input.path, is_not_there))) {
    throw CLI::ValidationError(option + " would replace the " + input.what +
                               " that is read; name another file");
  }
}

void addForceOption(CLI::App& app, bool& may_replace) {
  app.add_flag("--force", may_replace, "replace files that are there already")->group("Output");
}

void addCacheOptions(CLI::App& app, std::string& cache, bool& has_none) {
  const char* const group = "Kept fits";
  CLI::Option* option = app.add_option("--cache", cache,
                                       "where they are; default: the monitor's,\n"
                                       "~/.ros/collision_monitor/fits")
                            ->type_name("FOLDER")
                            ->group(group);
  app.add_flag("--no-cache", has_none, "fit anew and keep nothing")->excludes(option)->group(group);
}

}  // namespace collision_monitor::fit_tool
