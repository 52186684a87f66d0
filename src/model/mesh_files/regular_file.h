// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace collision_monitor {

/// [bytes] Files that are larger are refused where nothing else is said.
constexpr std::uintmax_t kUsualFileSize = 200'000'000;

/// The bytes of a regular file, or of what a symbolic link to one leads to.
///
/// Nothing else is opened: a pipe without a writer would be waited for, a device may do anything.
/// @param most [bytes]
/// @throws std::runtime_error with a sentence that names the file: not there, not readable, a
/// folder, pipe, socket or device, larger than `most`, also if it only grows so while it is read.
/// @throws Interrupted
std::string readRegularFile(const std::filesystem::path& path,
                            std::uintmax_t most = kUsualFileSize);

}  // namespace collision_monitor
