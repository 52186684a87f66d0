// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "memory_need.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {
namespace {

constexpr std::uint64_t kId = sizeof(std::uint32_t);

/// For CycleSetup::checked, ActivationDistances, PairEvents, PairMemory and BudgetTally. Blocks
/// hold about two pairs at their emptiest.
constexpr std::uint64_t kOfCheckedPair = sizeof(CheckedLinkPair) + sizeof(LinkBlock) / 2 +
                                         2 * sizeof(double) + sizeof(Verdict) + 4 * kId +
                                         sizeof(double) + 4 + sizeof(std::uint64_t) + kId;

/// For the table, its blocks and the distance cache.
constexpr std::uint64_t kOfBodyPair =
    2 * sizeof(BodyPair) + 2 * kId + sizeof(PairBlock) / 2 + sizeof(double);

/// For refinement, sweeps and the distance cache.
constexpr std::uint64_t kOfElementPair =
    sizeof(ElementPair) + 2 * kId + 1 + sizeof(double) + (kId + 2) + kId;

/// Lists of near pairs have room for all pairs, so that no cycle allocates. What they never fill
/// takes no memory: few of very many pairs are near at a time.
constexpr std::uint64_t roomForNear(std::uint64_t pairs) noexcept {
  constexpr std::uint64_t kMost = 250'000;
  return std::min(pairs, kMost);
}

/// For lists of pairs that are near.
constexpr std::uint64_t kOfNearLinkPair = sizeof(VerdictChange);
constexpr std::uint64_t kOfNearBodyPair = 2 * kId + sizeof(PairDistance) + sizeof(PassedContact);
constexpr std::uint64_t kOfNearElementPair = sizeof(RefineTask) + sizeof(SweepTask) + kId;

/// The lists of a broad phase that have room for all pairs of bodies.
constexpr std::uint64_t kBroadPhaseLists = 8;

/// For a RefineRoom.
std::uint64_t roomForMemories(std::uint64_t element_pairs) noexcept {
  if (element_pairs == 0) {
    return 0;
  }
  return std::min<std::uint64_t>(element_pairs, RefineRoom::kMostPlain) * sizeof(RefineMemory) +
         std::min<std::uint64_t>(element_pairs, RefineRoom::kMostMeshes) *
             (sizeof(MeshFront) + sizeof(KeptDepth) +
              RefineRoom::kBlocksOfPair * sizeof(MeshFront::Block)) +
         RefineRoom::kBlocksOfAll * sizeof(MeshFront::Block);
}

std::string bytesText(std::uint64_t bytes) {
  const double megabytes = 1e-6 * static_cast<double>(bytes);
  return megabytes < 10000.0 ? std::to_string(std::lround(megabytes)) + " MB"
                             : std::to_string(std::lround(1e-3 * megabytes)) + " GB";
}

}  // namespace

PairCounts countPairs(const CycleSetup& setup) {
  const std::vector<std::uint64_t> bodies = countByLink(setup.bodies, setup.model);
  const std::vector<std::uint64_t> elements = countByLink(setup.elements, setup.model);
  PairCounts counts;
  counts.bodies = setup.bodies.size();
  counts.links = static_cast<std::uint64_t>(
      std::count_if(bodies.begin(), bodies.end(), [](std::uint64_t count) { return count > 0; }));
  counts.link_pairs = !setup.link_pairs.empty() ? setup.link_pairs.size()
                      : counts.links < 2        ? 0
                                                : counts.links * (counts.links - 1) / 2;
  const LinkId first_of_world = firstOfWorld(setup.model);
  for (const LinkPair& pair : setup.link_pairs) {
    if (isChecked(pair.reason)) {
      ++counts.checked;
      counts.body_pairs += bodies[index(pair.a)] * bodies[index(pair.b)];
      const std::uint64_t of_elements = elements[index(pair.a)] * elements[index(pair.b)];
      counts.element_pairs += of_elements;
      counts.object_element_pairs += pair.b < first_of_world ? 0 : of_elements;
    }
  }
  return counts;
}

std::uint64_t memoryNeedOf(const PairCounts& counts) noexcept {
  return counts.link_pairs * sizeof(LinkPair) + counts.checked * kOfCheckedPair +
         counts.body_pairs * kOfBodyPair + counts.element_pairs * kOfElementPair +
         roomForNear(counts.checked) * kOfNearLinkPair +
         roomForNear(counts.body_pairs) * kOfNearBodyPair +
         roomForNear(counts.element_pairs) * kOfNearElementPair +
         roomForMemories(counts.element_pairs - counts.object_element_pairs) +
         roomForMemories(counts.object_element_pairs) +
         kBroadPhaseLists * sizeof(PairKey) * roomForPairs(counts.bodies);
}

void checkMemory(const PairCounts& counts, std::uint64_t limit, SetupReport& report) {
  const std::uint64_t available = limit > 0 ? limit : availableMemory();
  const std::uint64_t need = memoryNeedOf(counts);
  constexpr std::uint64_t kMostIds = 0xfffffff0U;
  const bool have_ids = std::max(counts.body_pairs, counts.element_pairs) < kMostIds;
  if (need <= available && have_ids) {
    return;
  }
  const std::string pairs =
      std::to_string(counts.links) + " links with shapes make " +
      std::to_string(counts.link_pairs) + " pairs" +
      (counts.checked == 0
           ? ""
           : ", of which " + std::to_string(counts.checked) + " are checked; these have " +
                 std::to_string(counts.body_pairs) + " pairs of shapes");
  const std::string most =
      need > available
          ? (limit > 0 ? "at most " + bytesText(available) + " (parameter memory_limit)"
                       : "at most " + bytesText(available) + ", as much as is available")
          : "at most " + std::to_string(kMostIds) + " pairs of shapes or elements";
  report.errors.push_back(
      {"memory",
       std::string("the set-up needs ") + (counts.checked == 0 ? "more than " : "") +
           bytesText(need) + ": its " + pairs,
       most,
       "to need less, leave out pairs (disable_collisions or disable_default_collisions in an "
       "SRDF, or the parameter ignore_pairs), or give the links fewer collision elements or "
       "shapes"});
}

}  // namespace collision_monitor
