// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a PLY file that lacks what its header announces. assimp 5.2 hangs if the header does not
/// end, takes missing numbers as 0, and reads beyond the end of a binary file.
/// @throws std::runtime_error
void checkPlyIsComplete(const std::string& bytes);

}  // namespace collision_monitor
