// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {

/// Joint values drawn uniformly within the limits; without limits within half a turn or 1 m.
/// Rotations of floating joints are uniform over all rotations.
JointPositions randomPositions(const RobotModel& model, std::mt19937_64& random);

}  // namespace collision_monitor
