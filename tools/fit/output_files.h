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
  bool may_replace{false};  ///< a file that is there already: --force, or the text was made of it
};

/// Adds an error if a file cannot be written: its folder is missing or closed, it is a folder, it
/// may not be changed, it is there and may not be replaced. Leaves nothing behind. For before the
/// long work.
/// @param option what messages call it: "option --yaml"
void checkWritable(const std::string& option, const OutputFile& file, SetupReport& report);

/// Writes all files under other names and renames them, so that whoever looks finds each either
/// as it was or whole. If one cannot be written, none is changed. Links to files stay, and files
/// that are replaced keep their mode and, where that is allowed, their owner.
/// Limits: a fault of the last step, the renaming, may leave some changed and others not.
/// @throws std::runtime_error with a sentence that names the file
void writeFiles(const std::vector<OutputFile>& files);

/// Where the file really is, behind all links.
std::filesystem::path targetOf(const std::filesystem::path& path);

}  // namespace collision_monitor::fit_tool
