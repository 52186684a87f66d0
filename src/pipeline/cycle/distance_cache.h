// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

/// Earlier distances, kept as lower bounds while bodies move.
namespace collision_monitor {

/// Makes an empty cache.
DistanceCache makeDistanceCache(const CycleSetup& setup);

/// Resets `nearest` for the distances of this cycle.
void forgetNearest(DistanceCache& cache) noexcept;

/// Resets `nearest_of_links`.
void forgetNearestOfLinks(DistanceCache& cache) noexcept;

/// Forgets all distances; travel stays.
void forgetDistances(DistanceCache& cache) noexcept;

/// Adds up the travel of bodies, so that cached distances stay lower bounds. Forgets the cache if a
/// link is known that was not known in the last cycle, or was in another part then.
/// @pre bodies are placed and looked ahead for; motions are found; memory.last is that of the last
/// cycle.
void accumulateTravel(const CycleSetup& setup, const LinkPoses& poses,
                      CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
