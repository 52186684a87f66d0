// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Whether an STL file is text. A header that says "solid" proves nothing: exporters write it into
/// binary files too. Text has no control bytes, and 512 bytes of triangles always do.
bool isTextStl(const std::string& bytes);

/// The text of an STL file that holds all its triangles.
///
/// assimp reads what it finds: half a file gives half a mesh without a word, which
/// would be a hole in every distance, so the counts are checked here first. Blanks and a byte order
/// mark before the first word, of which assimp knows nothing, are left out.
/// @throws std::runtime_error if the file ends before its triangles do.
/// @pre isTextStl
std::string completeTextStl(const std::string& bytes);

}  // namespace collision_monitor
