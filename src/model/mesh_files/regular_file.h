// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace collision_monitor {

/// [bytes] Default size limit: larger files are refused.
constexpr std::uintmax_t kUsualFileSize = 200'000'000;

/// The bytes of a regular file, also through a symbolic link.
///
/// Nothing else is opened: a pipe without a writer would block, and a device may do anything.
/// @param most [bytes]
/// @throws std::runtime_error with a sentence that names the file: it is missing, not readable, a
/// folder, pipe, socket or device, or larger than `most`, even if it grows beyond that during
/// reading.
/// @throws Interrupted
std::string readRegularFile(const std::filesystem::path& path,
                            std::uintmax_t most = kUsualFileSize);

}  // namespace collision_monitor
