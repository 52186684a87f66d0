// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Whether an STL file is text. A header that says "solid" is no proof: exporters write it into
/// binary files too. Text has no control bytes; 512 bytes of binary triangles always have some.
bool isTextStl(const std::string& bytes);

/// The text of an STL file that holds all its triangles.
///
/// assimp reads half a file as half a mesh, silently. Such a mesh would have a hole, so this
/// function checks the counts first. It removes blanks and a byte order mark before the first word,
/// which assimp does not accept.
/// @throws std::runtime_error if the file ends before its triangles do.
/// @pre isTextStl
std::string completeTextStl(const std::string& bytes);

}  // namespace collision_monitor
