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

/// What docs/decisions/broad-phase.md compares.
enum class BroadPhaseKind : unsigned char {
  automatic,
  brute_force,
  sweep_and_prune,
  hashed_bins,
  aabb_tree,
  neighbour_list,
  combination,  ///< sweep and prune for few bodies, hashed bins for many: the part of a combined
                ///< run that finds pairs, the rest of which is cullCandidates of the pipeline
};

/// One way to find pairs, and what it works on. Sized for a number of bodies at set-up.
struct BroadPhase {
  std::variant<Automatic, BruteForce, SweepAndPrune, HashedBins, AabbTree, NeighbourList> method;
  std::vector<SmallBox> boxes;
  std::vector<PairKey> meetings;
  std::vector<PairKey> scratch;
  std::vector<std::uint64_t> marks;  ///< one bit for each pair of a table
};

/// `pair_count`: of the table that findCandidates will get, if it is called.
BroadPhase makeBroadPhase(BroadPhaseKind kind, std::size_t body_count, std::size_t pair_count = 0);

/// All pairs of bodies whose bounds meet in single precision, rounded outward (SmallBox), sorted by
/// (a, b); the same from every method. Bodies that are not known, or whose bounds are no box,
/// stand in none.
/// Allocates nothing while as many meet as roomForPairs says.
/// @pre as many bodies as makeBroadPhase was told.
void findMeetings(BroadPhase& broad_phase, const BodyBounds& bounds,
                  std::vector<BodyPair>& meetings) noexcept;

/// Those of them that stand in the table, sorted by id. `candidates` must have room for every
/// pair of the table.
/// @pre as above, and of the table's size.
void findCandidates(BroadPhase& broad_phase, const BodyBounds& bounds, const PairTable& table,
                    std::vector<PairId>& candidates) noexcept;

}  // namespace collision_monitor
