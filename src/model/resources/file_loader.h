// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "model/mesh_files/regular_file.h"
#include "model/resources/package_search.h"

namespace collision_monitor {

/// Where files are looked for.
struct FileSources {
  /// Looked at before find_package, in order: each is a package or a folder of packages.
  std::vector<std::filesystem::path> package_roots;
  std::function<std::string(const std::string& name)> find_package{findPackage};  ///< "": not there
  /// Where packages are looked for, for messages.
  std::string package_places{
      "in the package roots, or where ROS_PACKAGE_PATH and AMENT_PREFIX_PATH lead to"};
  ResourceLoader load_other;  ///< loads or refuses other schemes; empty: all are refused
  std::uintmax_t max_size{kUsualFileSize};  ///< [bytes] of a file
};

/// Reads regular files by package:// and file:// URIs and absolute paths. Paths, packages and
/// file:// URIs may contain blanks and any letters. In the two kinds of URI, %XX is an escape.
/// Looks each package up once. Not for several threads at once.
/// @throws std::runtime_error from the loader, with a sentence: no such package, no regular file,
/// too large, or a scheme that is refused.
/// @throws Interrupted from the loader
ResourceLoader makeFileLoader(const FileSources& sources = {});

}  // namespace collision_monitor
