// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"

namespace collision_monitor::fit_tool {

/// Adds an error if a file cannot be written: its folder is missing or closed, it is a folder, it
/// may not be changed. Leaves nothing behind. For before the long work.
/// @param option what messages call it: "option --yaml"
void checkWritable(const std::string& option, const std::filesystem::path& path,
                   SetupReport& report);

struct OutputFile {
  std::filesystem::path path;
  std::string text;
};

/// Writes all files under other names and renames them, so that whoever looks finds each either
/// as it was or whole. If one cannot be written, none is changed.
/// Limits: a fault of the last step, the renaming, may leave some changed and others not.
/// @throws std::runtime_error with a sentence that names the file
void writeFiles(const std::vector<OutputFile>& files);

}  // namespace collision_monitor::fit_tool
