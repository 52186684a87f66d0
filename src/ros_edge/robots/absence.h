// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Whether nothing of a robot that can move is known: each link behind a joint that moves is
/// unknown beside the link before it, as when its driver is switched off. For a robot without such
/// joints: whether its root is not placed. A robot of which only a part is lost is not absent.
bool isAbsent(const RobotModel& model, RobotId robot, const LinkPoses& poses);

}  // namespace collision_monitor
