// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fit_cache_folder.h"

#include <cstdlib>

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

}  // namespace collision_monitor
