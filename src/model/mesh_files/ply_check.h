// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a PLY file that lacks what its header announces: assimp 5.2 never returns from one
/// whose header does not end, takes numbers that are missing for 0, and reads whatever lies behind
/// the end of a binary one.
/// @throws std::runtime_error
void checkPlyIsComplete(const std::string& bytes);

}  // namespace collision_monitor
