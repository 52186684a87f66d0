// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "exercise.h"

namespace collision_monitor::two_capsules {

/// The whole picture for rviz; deletes the former one. Namespaces: `board`, a thin plate to click
/// on, its upper face at z = 0; `prompt`; `clicks`; `capsules`; and, once both capsules exist,
/// `distance` (id 0 = line, id 1 = its ends) and `label`.
/// Frames: that of the board, whose name is `frame`.
visualization_msgs::MarkerArray draw(const Exercise& exercise, const std::string& frame);

}  // namespace collision_monitor::two_capsules
