// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {

/// What a joint with a variable of its own may do.
struct JointRange {
  JointId joint{};
  double lower{0.0};  ///< [rad] or [m]
  double upper{0.0};
  bool is_whole{false};  ///< false: it may do more
};

/// Of the joints with one variable of their own. A full turn is all that a continuous joint can do.
std::vector<JointRange> jointRanges(const RobotModel& model);

/// A state with every variable in its range; planar and floating joints go up to a metre along each
/// axis, and turn anyhow.
JointPositions drawState(const RobotModel& model, const std::vector<JointRange>& ranges,
                         std::mt19937_64& random);

}  // namespace collision_monitor
