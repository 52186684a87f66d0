// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a DAE file that assimp 5.2 does not survive: of which it would read beyond the end of an
/// array or make room for more values than the file can hold; whose primitives, `<p>`, hold
/// anything but indices; whose elements or nodes nest too deeply, or without end. Limits: says
/// nothing of what is no XML, for assimp does.
/// @throws std::runtime_error
void checkDae(const std::string& bytes);

}  // namespace collision_monitor
