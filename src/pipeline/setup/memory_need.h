// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "collision_monitor/pipeline/setup.h"

/// How much memory pairs take: what grows with the square of links is known before it is taken.
namespace collision_monitor {

/// Of what a set-up and the buffers of its cycles hold.
struct PairCounts {
  std::uint64_t links{0};  ///< with shapes
  std::uint64_t bodies{0};
  std::uint64_t link_pairs{0};     ///< checked or not
  std::uint64_t checked{0};        ///< pairs of links
  std::uint64_t body_pairs{0};     ///< of checked pairs of links
  std::uint64_t element_pairs{0};  ///< of checked pairs of links
};

/// @pre bodies and elements are made; with link_pairs not yet decided, all pairs but those of links
/// are 0.
PairCounts countPairs(const CycleSetup& setup);

/// [bytes] What a set-up and the buffers of its cycles take for pairs, at most, while many are
/// near. Error: about a tenth too many.
std::uint64_t memoryNeedOf(const PairCounts& counts) noexcept;

/// [bytes] What this process may still take: the least that memory of the machine, limits of the
/// process and of its control group leave.
std::uint64_t availableMemory();

/// Adds an error where pairs would take more memory than `limit`, or are too many to have ids.
/// @param limit [bytes] 0: availableMemory()
void checkMemory(const PairCounts& counts, std::uint64_t limit, SetupReport& report);

}  // namespace collision_monitor
