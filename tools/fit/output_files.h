// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"

namespace collision_monitor::fit_tool {

/// A file to be written.
struct OutputFile {
  std::filesystem::path path;
  std::string text{};
  bool may_replace{false};  ///< an existing file: by --force, or as the source of the text
};

/// Adds an error if a file cannot be written: its folder is missing or read-only; it is itself a
/// folder or read-only; it exists and must not be replaced. Changes nothing on disk. For use before
/// long work.
/// @param option its name in messages: "option --yaml"
void checkWritable(const std::string& option, const OutputFile& file, SetupReport& report);

/// Writes all files under temporary names and renames them, so that readers see each file either
/// unchanged or complete. If one cannot be written, none is changed. Symbolic links stay. Replaced
/// files keep their mode and, where permitted, their owner.
/// Limits: if renaming fails, some files may be changed and others not.
/// @throws std::runtime_error with a sentence that names the file
void writeFiles(const std::vector<OutputFile>& files);

/// The file's real path, with all links resolved.
std::filesystem::path targetOf(const std::filesystem::path& path);

}  // namespace collision_monitor::fit_tool
