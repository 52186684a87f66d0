// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/broad_phase.h"

#include "collision_monitor/geometry/visit_held.h"

namespace collision_monitor {
namespace {

void findCandidatesOf(BruteForce&, const BodyBounds& bounds, const PairTable& table,
                      std::vector<PairId>& candidates) noexcept {
  candidates.clear();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const BodyPair& pair = table.pairs()[i];
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    if (bounds.known[a] != 0 && bounds.known[b] != 0 && meets(bounds.boxes[a], bounds.boxes[b])) {
      candidates.push_back(idAt<PairId>(i));
    }
  }
}

void findCandidatesOf(SweepAndPrune& sweep_and_prune, const BodyBounds& bounds,
                      const PairTable& table, std::vector<PairId>& candidates) noexcept {
  sweep_and_prune.findCandidates(bounds, table, candidates);
}

}  // namespace

void findCandidates(BroadPhase& broad_phase, const BodyBounds& bounds, const PairTable& table,
                    std::vector<PairId>& candidates) noexcept {
  visitHeld([&](auto& chosen) { findCandidatesOf(chosen, bounds, table, candidates); },
            broad_phase);
}

}  // namespace collision_monitor
