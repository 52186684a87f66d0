// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/pipeline/setup.h"

/// How much memory pairs take. It grows with the square of links, so it is checked beforehand.
namespace collision_monitor {

/// The sizes of a set-up and its buffers.
struct PairCounts {
  std::uint64_t links{0};  ///< links with shapes
  std::uint64_t bodies{0};
  std::uint64_t link_pairs{0};            ///< checked or not
  std::uint64_t checked{0};               ///< link pairs
  std::uint64_t body_pairs{0};            ///< of checked link pairs
  std::uint64_t element_pairs{0};         ///< of checked link pairs
  std::uint64_t object_element_pairs{0};  ///< those of them that are of an object
};

/// By LinkId: the number of bodies or elements.
template <class Part>
std::vector<std::uint64_t> countByLink(const std::vector<Part>& parts, const RobotModel& model) {
  std::vector<std::uint64_t> counts(model.links.size(), 0);
  for (const Part& part : parts) {
    ++counts[index(part.link)];
  }
  return counts;
}

/// @pre bodies and elements are made. Before link_pairs are decided, only counts of bodies and
/// links are not 0.
PairCounts countPairs(const CycleSetup& setup);

/// [bytes] An upper bound of what a set-up and its buffers take for pairs, while many are near.
/// Error: about a tenth too large.
std::uint64_t memoryNeedOf(const PairCounts& counts) noexcept;

/// [bytes] What this process may still take: the least that the machine, the limits of the process
/// and its control group leave.
std::uint64_t availableMemory();

/// Adds an error if pairs would take more memory than `limit`, or are too many for their ids.
/// @param limit [bytes] 0: availableMemory()
void checkMemory(const PairCounts& counts, std::uint64_t limit, SetupReport& report);

}  // namespace collision_monitor
