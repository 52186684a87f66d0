// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Text of somebody else, made fit for a message.
namespace collision_monitor {

/// With characters that rewrite a terminal or show nothing by their numbers: "\x1b" for a control
/// character, "<U+00A0>" for a space that is none of ASCII's, and for marks of direction.
std::string visibleText(std::string_view text);

/// With all that is not ASCII by its number.
std::string asciiText(std::string_view text);

bool isAscii(std::string_view text) noexcept;

}  // namespace collision_monitor
