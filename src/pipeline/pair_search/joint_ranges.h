// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {

/// The range of a joint with a variable of its own.
struct JointRange {
  JointId joint{};
  double lower{0.0};  ///< [rad] or [m]
  double upper{0.0};
  bool is_whole{false};  ///< false: the joint may leave the range
};

/// The ranges of joints with one variable of their own. A continuous joint has a full turn.
std::vector<JointRange> jointRanges(const RobotModel& model);

/// Draws a state with every variable in its range. Planar and floating joints move up to one metre
/// along each axis and turn to any angle.
JointPositions drawState(const RobotModel& model, const std::vector<JointRange>& ranges,
                         std::mt19937_64& random);

}  // namespace collision_monitor
