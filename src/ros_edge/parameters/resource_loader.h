// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "model/mesh_files/regular_file.h"

namespace collision_monitor {

/// What may be loaded, with limits.
struct LoadRules {
  std::uintmax_t max_size{kUsualFileSize};  ///< [bytes] of a file
  std::vector<std::string> schemes;  ///< allowed beside package and file, such as http; lower case
  double download_time{30.0};        ///< [s] from the name look-up to the end of the download
  std::vector<std::filesystem::path> package_roots;  ///< looked at before ROS_PACKAGE_PATH
  std::string package_places{"where ROS_PACKAGE_PATH leads to"};  ///< as in FileSources
};

/// Reads files as makeFileLoader, and asks rospack for packages. Fetches other allowed schemes by
/// resource_retriever, in a separate process that is ended after its time limit
/// (docs/decisions/helper-processes.md). This loader does not ask a server again that was too slow
/// once.
/// Not for several threads at once.
/// @throws std::exception from the loader, with a sentence: no such package, no regular file, too
/// large, a scheme that is not allowed, too slow, or curl's error.
/// @throws Interrupted from the loader
ResourceLoader makeResourceLoader(const LoadRules& rules = {});

}  // namespace collision_monitor
