// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

/// Distances that were measured once, kept as lower bounds while bodies move.
namespace collision_monitor {

/// Nothing known.
DistanceCache makeDistanceCache(const CycleSetup& setup);

/// Forgets `nearest`, for the distances of this cycle.
void forgetNearest(DistanceCache& cache) noexcept;

/// Follows how far bodies have come, so that gaps stay what they are.
/// Where a link was not known in the last cycle, or in another part, all gaps are forgotten.
/// @pre bodies are placed and bounded; motions are found; memory.last is that of the last cycle.
void accumulateTravel(const CycleSetup& setup, const LinkPoses& poses,
                      CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
