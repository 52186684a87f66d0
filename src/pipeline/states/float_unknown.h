// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/kinematics/state_kinematics.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Where nothing is known, a part begins that is held at the identity: its links keep their places
/// beside each other, whatever it hangs on.
/// @param poses links get their parts
StandingPoses floatUnknown(const RobotModel& model, StandingPoses standing, LinkPoses& poses);

}  // namespace collision_monitor
