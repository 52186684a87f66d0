// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// The verdict of a pair by its distance [m] and time to contact [s]. It is raised at its threshold
/// and left only `hysteresis` beyond it.
Verdict verdictFor(double distance, double time, const Limits& limits, Verdict before) noexcept;

/// Decides which distance represents two links: a certain contact, even if a lower bound is deeper.
/// Beside an overlap that is estimated, an exact depth of other elements is an estimate, too.
/// @param estimated index into `pairs` of the deepest estimate, or kNone
/// @param closest index into `pairs` of the least distance
void preferEstimate(std::uint32_t estimated, std::vector<PairDistance>& pairs,
                    std::uint32_t& closest) noexcept;

/// Judges the pairs that have a distance or are lively, or all if `memory.judges_all`. The closest
/// distance of links that overlap by an estimate becomes an estimate, too.
void judgePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                const LinkVelocities& velocities, PairDistances& distances, PairMemory& memory,
                PairEvents& events) noexcept;

/// Forgets which pairs were looked at, and what was told of them besides their verdicts.
void forgetTold(PairEvents& events) noexcept;

/// Keeps which pairs the next cycle judges even if they have no distance: those that are not clear,
/// that listeners do not know to be clear, or that the speed scale remembers. Where pairs are few,
/// it judges all.
void keepLively(const CycleSetup& setup, const PairEvents& events, PairMemory& memory) noexcept;

}  // namespace collision_monitor
