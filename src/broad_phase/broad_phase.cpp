// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/broad_phase.h"

#include <algorithm>

#include "broad_phase/marked_pairs.h"
#include "geometry/bvh/visit_held.h"

namespace collision_monitor {
namespace {

/// From this number on, hashed bins beat sweep and prune unless motion is very small.
constexpr std::size_t kManyBodies = 1000;

using Method = decltype(BroadPhase::method);

Method makeMethod(BroadPhaseKind kind, std::size_t body_count) {
  switch (kind) {
    case BroadPhaseKind::automatic:
      return Automatic(body_count);
    case BroadPhaseKind::brute_force:
      return BruteForce(body_count);
    case BroadPhaseKind::sweep_and_prune:
      return SweepAndPrune(body_count);
    case BroadPhaseKind::hashed_bins:
      return HashedBins(body_count);
    case BroadPhaseKind::aabb_tree:
      return AabbTree(body_count);
    case BroadPhaseKind::neighbour_list:
      return NeighbourList(body_count);
    case BroadPhaseKind::combination:
      if (body_count < kManyBodies) {
        return SweepAndPrune(body_count);
      }
      return HashedBins(body_count);
  }
  return Automatic(body_count);
}

/// @pre the boxes are filled.
void fillMeetings(BroadPhase& broad_phase) noexcept {
  visitHeld([&](auto& method) { method.findMeetings(broad_phase.boxes, broad_phase.meetings); },
            broad_phase.method);
}

/// Marks the pairs if testing every pair of the table is fastest, or if that method was asked for.
/// @return false for all other methods.
bool markPairs(BroadPhase& broad_phase, const PairTable& table) noexcept {
  if (table.idsOfAll() == nullptr) {
    return false;
  }
  if (auto* brute_force = std::get_if<BruteForce>(&broad_phase.method)) {
    brute_force->markPairs(broad_phase.boxes, table, broad_phase.marks);
    return true;
  }
  auto* automatic = std::get_if<Automatic>(&broad_phase.method);
  return automatic != nullptr && automatic->markPairs(broad_phase.boxes, table, broad_phase.marks);
}

void markMeetings(BroadPhase& broad_phase, const PairTable& table) noexcept {
  fillMeetings(broad_phase);
  for (const PairKey meeting : broad_phase.meetings) {
    PairId pair{};
    if (table.find(BodyId{lowerBody(meeting)}, BodyId{upperBody(meeting)}, pair)) {
      markPair(index(pair), broad_phase.marks);
    }
  }
}

}  // namespace

BroadPhase makeBroadPhase(BroadPhaseKind kind, std::size_t body_count, std::size_t pair_count) {
  BroadPhase broad_phase{makeMethod(kind, body_count), {}, {}, {}, MarkedPairs(pair_count)};
  broad_phase.boxes.resize(body_count, emptyBox());
  broad_phase.meetings.reserve(roomForPairs(body_count));
  broad_phase.scratch.reserve(roomForPairs(body_count));
  return broad_phase;
}

void findMeetings(BroadPhase& broad_phase, const BodyBounds& bounds,
                  std::vector<BodyPair>& meetings) noexcept {
  fillSmallBoxes(bounds, broad_phase.boxes);
  fillMeetings(broad_phase);
  sortPairs(bounds.boxes.size(), broad_phase.meetings, broad_phase.scratch);
  meetings.resize(broad_phase.meetings.size());
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const PairKey pair = broad_phase.meetings[i];
    meetings[i] = {BodyId{lowerBody(pair)}, BodyId{upperBody(pair)}};
  }
}

void findCandidates(BroadPhase& broad_phase, const BodyBounds& bounds, const PairTable& table,
                    std::vector<PairId>& candidates) noexcept {
  fillSmallBoxes(bounds, broad_phase.boxes);
  if (!markPairs(broad_phase, table)) {
    markMeetings(broad_phase, table);
  }
  takeMarked(broad_phase.marks, candidates);
}

}  // namespace collision_monitor
