// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Whether nothing is heard of a robot that can move: for each link behind a joint that moves, no
/// pose beside the link before it came, or none for max_age, as when its driver is switched off.
/// For a robot without such joints: the same of its root. A robot of which only a part is lost is
/// not absent, nor is one of which something contradicted or not finite is heard.
bool isAbsent(const RobotModel& model, RobotId robot, const LinkPoses& poses);

}  // namespace collision_monitor
