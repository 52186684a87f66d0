// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "broad_phase/automatic.h"
#include "broad_phase/methods/aabb_tree.h"
#include "broad_phase/methods/brute_force.h"
#include "broad_phase/methods/hashed_bins.h"
#include "broad_phase/methods/neighbour_list.h"
#include "broad_phase/methods/sweep_and_prune.h"
#include "collision_monitor/broad_phase/body_bounds.h"
#include "collision_monitor/broad_phase/pair_table.h"

namespace collision_monitor {

/// The methods that docs/decisions/broad-phase.md compares.
enum class BroadPhaseKind : unsigned char {
  automatic,
  brute_force,
  sweep_and_prune,
  hashed_bins,
  aabb_tree,
  neighbour_list,
  combination,  ///< sweep and prune for few bodies, hashed bins for many: the part of a combined
                ///< run that finds pairs; the rest is cullCandidates of the pipeline
};

/// A method that finds pairs, with its buffers. Sized for a number of bodies at set-up.
struct BroadPhase {
  std::variant<Automatic, BruteForce, SweepAndPrune, HashedBins, AabbTree, NeighbourList> method;
  std::vector<SmallBox> boxes;
  std::vector<PairKey> meetings;
  std::vector<PairKey> scratch;
  MarkedPairs marks;
};

/// @param pair_count the size of the table for findCandidates; 0 without calls of it.
BroadPhase makeBroadPhase(BroadPhaseKind kind, std::size_t body_count, std::size_t pair_count = 0);

/// Finds all pairs of bodies whose bounds meet in single precision, rounded outward (SmallBox),
/// sorted by (a, b). Every method gives the same pairs. A body that is unknown, or whose bounds are
/// no box, is in no pair. Allocates nothing for up to roomForPairs pairs.
/// @pre as many bodies as given to makeBroadPhase.
void findMeetings(BroadPhase& broad_phase, const BodyBounds& bounds,
                  std::vector<BodyPair>& meetings) noexcept;

/// Finds the pairs of the table whose bounds meet, sorted by id.
/// @pre as findMeetings; the table has the pair_count of makeBroadPhase; `candidates` has room for
/// every pair of the table.
void findCandidates(BroadPhase& broad_phase, const BodyBounds& bounds, const PairTable& table,
                    std::vector<PairId>& candidates) noexcept;

}  // namespace collision_monitor
