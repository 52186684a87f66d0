// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/kinematics/state_kinematics.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Begins a part that floats, at the identity, at each root or joint whose pose is unknown.
/// @param poses its links get their parts
StandingPoses floatUnknown(const RobotModel& model, StandingPoses standing, LinkPoses& poses);

}  // namespace collision_monitor
