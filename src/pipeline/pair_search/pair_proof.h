// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "pipeline/pair_search/cell_bounds.h"
#include "pipeline/pair_search/touch.h"

/// Proofs about a pair of links for all states within the joints' ranges, by branch and bound over
/// cells of these ranges.
namespace collision_monitor {

/// What proofs share: one for each thread.
struct ProofTools {
  explicit ProofTools(const CycleSetup& setup, const std::vector<ElementCover>& element_covers)
      : measures(setup), covers(element_covers) {}

  LinkPairMeasures measures;
  const std::vector<ElementCover>& covers;
  ConvexWorkspace workspace;
  std::vector<ConvexWarmStart> warm;  ///< by element pair of the current link pair
  Levers levers;
  SweepScratch sweep;
  std::vector<double> first_order;
  std::vector<double> shares;  ///< [m] by variable: how much it does against the proof
};

/// Makes the tools as if they had not measured the pair, so that answers do not depend on the
/// thread.
void forgetPair(ProofTools& tools, LinkPairIndex pair);

enum class ProofState : unsigned char { open, proven, refuted };

/// A proof under way. It may stop after any cell and go on later, on another thread.
struct PairProof {
  LinkPairIndex pair{0};
  bool of_touching{false};  ///< that the links touch in every state; else that in none
  PairMotion motion;
  std::vector<Pose> world_from_root;
  std::vector<JointCell> open;  ///< cells still to be proven, the next one last
  std::size_t cells{0};         ///< number of visited cells
  bool is_stuck{false};         ///< a cell can neither be proven nor cut
  ProofState state{ProofState::open};
  Touch found{Touch::apart};  ///< refuted: what the links do in `at`
  JointPositions at;
};

/// Whether a proof can go on.
inline bool isUnderWay(const PairProof& proof) noexcept {
  return proof.state == ProofState::open && !proof.is_stuck && !proof.open.empty();
}

/// A proof that can be tried, with the ranges as its first cell. Open without cells: no proof
/// covers what moves the links.
PairProof beginProof(const CycleSetup& setup, LinkPairIndex pair, PairMotion motion,
                     const std::vector<Pose>& world_from_root);

using Deadline = std::chrono::steady_clock::time_point;

/// Visits cells until the proof is done, `most_cells` were visited in all, or the deadline is over.
///
/// That links are apart: each pair of elements is tried by swept balls, then by the distance of
/// bodies in the middle of the cell against the levers, then along the normal of their hulls, then
/// by the distance of meshes against the levers. Pairs of elements that are proven apart in a cell
/// are so in its halves.
/// That links touch: the penetration depth of two convex geometries that lie in elements exceeds
/// their levers.
/// A cell that is not proven is cut across the variable that does most against it.
///
/// Limits: a cell whose middle speaks against the proof ends it.
void advance(ProofTools& tools, std::size_t most_cells, Deadline deadline, PairProof& proof);

}  // namespace collision_monitor
