// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a DAE file that could crash or stall assimp 5.2: assimp would read beyond the end of an
/// array, or allocate more values than the file can hold; `<p>` of a primitive holds anything but
/// indices; elements or nodes nest too deeply or endlessly.
/// Limits: ignores text that is no XML; assimp reports that.
/// @throws std::runtime_error
void checkDae(const std::string& bytes);

}  // namespace collision_monitor
