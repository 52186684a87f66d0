// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/data/robot_speeds.h"

namespace collision_monitor {

/// Whether what is unknown between two robots counts for the first of them, whatever was known
/// before.
inline bool countsFor(const RobotSpeeds& robots, std::size_t robot, std::size_t other) noexcept {
  return robot == other || robots.is_excused[other] == 0;
}

/// Finds the speed scale: the least that a pair asks for. It is 0 while a pair is unknown, and
/// where links met since the last cycle. That of a robot follows from the pairs of links that it
/// moves.
/// @param reported PairMemory::reported: pairs that are unknown there were near before
void scaleSpeed(const CycleSetup& setup, std::int64_t stamp_ns, const PairDistances& distances,
                const PairEvents& events, const std::vector<Verdict>& reported, SpeedScale& speed,
                RobotSpeeds& robots) noexcept;

}  // namespace collision_monitor
