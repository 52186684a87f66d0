// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace collision_monitor {

/// How mesh files are read. A malformed one may crash the library that does it, or keep it busy for
/// ever; so a program of this package does, and this process lives on
/// (docs/decisions/helper-processes.md). Binary STLs need none.
struct MeshReading {
  double seconds{60.0};  ///< a file may take, more than 0
  double memory{2e9};    ///< [bytes] a file may take
  /// That reads; empty: `read_meshes` as installed beside this library.
  std::filesystem::path program;
  /// Read in this process, without limits: for programs that have this library alone and trust
  /// their meshes.
  bool is_in_process{false};
};

}  // namespace collision_monitor
