// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor::fit_tool {

/// Escapes text for HTML and XML, between tags and in attributes. Control characters are not
/// allowed there and become question marks.
std::string escaped(const std::string& text);

/// Source: RFC 4648, section 4.
std::string base64Of(const std::string& bytes);

}  // namespace collision_monitor::fit_tool
