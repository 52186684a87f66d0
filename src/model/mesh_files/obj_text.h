// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// An OBJ file as assimp reads all of it.
///
/// assimp 5.2 passes over a vertex without a word if its line begins with a blank, if a
/// number begins with a point (".5"), or if it has neither 3, 4 nor 6 of them. Faces
/// name vertices by their number, so all that follow would be others than were meant. Here lines
/// lose blanks at their begin, comments and line breaks behind a backslash, and vertices have three
/// coordinates, or four where there is a weight; colours are left out.
/// @throws std::runtime_error if a vertex has no three numbers; it names the line.
std::string plainObj(const std::string& bytes);

}  // namespace collision_monitor
