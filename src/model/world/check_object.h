// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Checks what an object says of itself: shapes, sizes, poses, padding and colour. Adds every
/// fault; @param where stands before them, as in Problem.
/// @return whether there is none.
bool checkObject(const WorldObject& object, const std::string& where, SetupReport& report);

/// Checks a pose from outside: rigid, and no farther than kFarthestObject.
bool checkPlacing(const Pose& pose, const std::string& where, SetupReport& report);

}  // namespace collision_monitor
