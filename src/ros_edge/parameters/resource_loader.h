// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "model/mesh_files/regular_file.h"

namespace collision_monitor {

/// What may be loaded, and what it may take.
struct LoadRules {
  std::uintmax_t max_size{kUsualFileSize};  ///< [bytes] of a file
  std::vector<std::string> schemes;         ///< beside package and file, as http; in small letters
  double download_time{30.0};               ///< [s] from the first look for the computer to the end
};

/// Reads regular files by package:// and file:// URIs and plain absolute paths; whatever else the
/// rules allow through resource_retriever, in a process of its own that is ended when its time is
/// over (docs/decisions/helper-processes.md). A server that did not answer in time is not asked
/// again by this loader. Blanks and letters of any language may stand in paths, packages and
/// file:// URIs; in the latter two %XX is an escape, as in any URI.
/// Not for several threads at once.
/// @throws std::exception from the loader, with a sentence: no such package, no regular file, too
/// large, a scheme that is not allowed, no answer in time, or what curl says.
/// @throws Interrupted from the loader
ResourceLoader makeResourceLoader(const LoadRules& rules = {});

}  // namespace collision_monitor
