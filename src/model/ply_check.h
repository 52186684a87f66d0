// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Refuses a PLY file that is cut short: assimp 5.2 never returns from one whose
/// header does not end, and reads what is there of one whose elements are fewer
/// than its header announces.
/// Limits: of binary files only the header is checked against the size: an element
/// takes a byte at least.
/// @throws std::runtime_error
void checkPlyIsComplete(const std::string& bytes);

}  // namespace collision_monitor
