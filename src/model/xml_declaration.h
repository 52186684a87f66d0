// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// The text with an XML declaration that stands behind comments made blank; lines keep their
/// numbers. XML allows nothing before it and tinyxml2 refuses such a text, but urdfdom takes it,
/// and robots are published whose licence stands there.
std::string withoutLateDeclaration(std::string xml);

}  // namespace collision_monitor
