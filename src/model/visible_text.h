// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Makes foreign text safe for a message.
namespace collision_monitor {

/// Replaces characters that control a terminal or are invisible by their codes: "\x1b" for a
/// control character, "<U+00A0>" for non-ASCII spaces and for direction marks.
std::string visibleText(std::string_view text);

/// Replaces everything outside ASCII by its code.
std::string asciiText(std::string_view text);

bool isAscii(std::string_view text) noexcept;

/// The place of the first byte that is no part of UTF-8; the size of the text if there is none.
std::size_t firstNoUtf8(std::string_view text) noexcept;

}  // namespace collision_monitor
