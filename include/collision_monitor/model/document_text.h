// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// What a user writes beside URDF and SRDF: rules for shapes or pairs, or objects.
struct DocumentText {
  std::string source{};     ///< its name in messages: a file or a parameter
  std::string text{};       ///< empty: nothing is given
  std::string directory{};  ///< base of relative names of files in it, "" if unknown
};

}  // namespace collision_monitor
