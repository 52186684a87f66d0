// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// The folder that a value of `fit_cache` means: "" the usual one below $ROS_HOME or ~/.ros, "none"
/// nothing, else the folder itself, with ~ for the home folder. Nothing where neither is known.
std::filesystem::path fitCacheFolder(const std::string& parameter);

/// The options of the parameters, with the text of the rules file read anew. A file
/// that cannot be read is added to `report`.
SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report);

}  // namespace collision_monitor
