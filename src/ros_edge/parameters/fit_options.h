// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// The folder for a value of `fit_cache`: "" is the default below $ROS_HOME or ~/.ros; "none" is no
/// folder; anything else is the folder itself, where ~ is the home folder. Empty if neither is
/// known.
std::filesystem::path fitCacheFolder(const std::string& parameter);

/// The options from the parameters, with the rules file read again. If it cannot be read, an error
/// is added to `report`.
SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report);

}  // namespace collision_monitor
