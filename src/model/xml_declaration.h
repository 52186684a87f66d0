// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Blanks an XML declaration that comes after comments; line numbers stay the same. XML allows
/// nothing before a declaration, and tinyxml2 refuses such a text. But urdfdom accepts it, and some
/// published robots have their licence there.
std::string withoutLateDeclaration(std::string xml);

}  // namespace collision_monitor
