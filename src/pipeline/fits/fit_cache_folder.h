// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace collision_monitor {

/// The folder for a value of `fit_cache`: "" is the default below $ROS_HOME or ~/.ros; "none" is no
/// folder; anything else is the folder itself, where ~ is the home folder. Empty if neither is
/// known. The default is the same without ROS, so that all programs share their fits.
std::filesystem::path fitCacheFolder(const std::string& parameter);

}  // namespace collision_monitor
