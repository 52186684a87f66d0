// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace collision_monitor {

/// The other name in `known` with the fewest edits to `name`. Capitals count as small letters.
/// Empty if none is similar (more than a third of the letters differ).
/// Source: Levenshtein distance by the dynamic programming of Wagner and Fischer (1974).
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

/// ", did you mean 'NAME'?" or nothing.
std::string suggestion(const std::string& name, const std::vector<std::string>& known);

}  // namespace collision_monitor
