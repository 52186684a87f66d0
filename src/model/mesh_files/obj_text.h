// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// Rewrites an OBJ file so that assimp reads all of it.
///
/// assimp 5.2 silently skips a vertex if its line begins with a blank, if a number begins with a
/// point (".5"), or if it does not have 3, 4 or 6 numbers. Faces refer to vertices by number, so a
/// skipped vertex shifts all that follow. The rewritten lines have no leading blanks, comments or
/// backslash line breaks. Vertices have three coordinates, or four if there is a weight; colors are
/// left out.
/// @throws std::runtime_error if a vertex has no three numbers; it names the line.
std::string plainObj(const std::string& bytes);

}  // namespace collision_monitor
