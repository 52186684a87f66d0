// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// The bytes of an STL file as far as they hold triangles.
///
/// assimp reads what it finds: half an ASCII file gives half a mesh without a
/// word, and a binary file with bytes to spare is not recognised. Half a mesh
/// would be a hole in every distance, so the counts are checked here first. Text loses
/// blanks and a byte order mark before its first word, of which assimp knows nothing.
/// @throws std::runtime_error if the file ends before its triangles do.
std::string completeStl(const std::string& bytes);

}  // namespace collision_monitor
