// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace collision_monitor {

/// How mesh files are read. A malformed file may crash the library that reads it or keep it busy
/// for ever. A separate program of this package reads them, so this process survives
/// (docs/decisions/helper-processes.md). Binary STLs do not need it.
struct MeshReading {
  double seconds{60.0};  ///< time that one file may take, more than 0
  double memory{2e9};    ///< [bytes] memory that one file may take
  /// The program that reads; empty: `read_meshes` as installed beside this library.
  std::filesystem::path program;
  /// Read in this process, without limits: for programs that have only this library and trust their
  /// meshes.
  bool is_in_process{false};
};

}  // namespace collision_monitor
