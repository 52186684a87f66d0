// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a DAE file of which assimp 5.2 would read beyond the end of an array, or whose
/// primitives, `<p>`, hold anything but indices: it never gets past that, and takes more and more
/// memory.
/// Limits: says nothing of what is no XML, for assimp does.
/// @throws std::runtime_error
void checkDaeArrays(const std::string& bytes);

}  // namespace collision_monitor
