// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/fit_options.h"

#include <cstdlib>
#include <exception>

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

/// Empty if the variable is not set.
fs::path folderIn(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? fs::path() : fs::path(value);
}

}  // namespace

fs::path fitCacheFolder(const std::string& parameter) {
  if (parameter == "none") {
    return {};
  }
  const fs::path home = folderIn("HOME");
  if (!parameter.empty()) {
    return parameter.rfind("~/", 0) == 0 && !home.empty() ? home / parameter.substr(2)
                                                          : fs::path(parameter);
  }
  const fs::path ros_home = folderIn("ROS_HOME");
  if (!ros_home.empty()) {
    return ros_home / "collision_monitor" / "fits";
  }
  return home.empty() ? fs::path() : home / ".ros" / "collision_monitor" / "fits";
}

SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report) {
  SetupOptions options = parameters.setup;
  options.fit_cache = fitCacheFolder(parameters.fit_cache);
  if (parameters.shape_rules.empty()) {
    return options;
  }
  options.shape_rules.source = parameters.shape_rules;
  try {
    options.shape_rules.yaml = load_resource(parameters.shape_rules);
  } catch (const std::exception& fault) {
    report.errors.push_back({options.where + "shape_rules '" + parameters.shape_rules + "'",
                             fault.what(), "a readable file or package:// URI"});
  }
  return options;
}

}  // namespace collision_monitor
