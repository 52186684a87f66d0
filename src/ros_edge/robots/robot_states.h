// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/RobotState.h>

#include <string>
#include <vector>

#include "ros_edge/watch.h"

/// What State says of each robot.
namespace collision_monitor {

/// Fills the states of all listed robots, in their order.
///
/// A robot's level is that of the worst pair of its links. A pair that is unknown counts for both
/// of its robots, but not against another robot that may be absent and is (is_excused).
/// @param blind_reason why nothing at all can be judged; empty if pairs are judged
void fillRobotStates(const Watch& watch, const CycleFacts& facts, const std::string& blind_reason,
                     std::vector<RobotState>& states);

}  // namespace collision_monitor
