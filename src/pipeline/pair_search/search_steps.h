// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "collision_monitor/pipeline/search_pairs.h"
#include "pipeline/pair_search/pair_proof.h"

namespace collision_monitor {

/// The states of a link pair that were found.
struct SeenPair {
  bool is_fixed{false};  ///< the links do not move against each other: one state suffices
  bool is_apart{false};
  bool is_touching{false};
  bool is_unclear{false};
  JointPositions touching;  ///< the first touching state, or the first unclear one
  JointPositions nearest_state;
  double nearest{std::numeric_limits<double>::infinity()};  ///< [m] of enclosing shapes

  bool isDecided() const noexcept {
    return is_fixed ? is_apart || is_touching || is_unclear : is_apart && is_touching;
  }
};

/// Draws states and measures all pairs in them, as described at searchPairs.
/// @param seen by LinkPairIndex; is_fixed is filled in
void drawStates(const PairSearchOptions& options, const std::vector<JointRange>& ranges,
                const std::vector<Pose>& world_from_root, LinkPairMeasures& measures,
                std::vector<SeenPair>& seen);

/// Notes what a state showed.
void keep(Touch touch, const JointPositions& state, SeenPair& seen);

/// Searches downhill from the nearest state of each pair that never touched, on all cores.
/// @param proofs by LinkPairIndex
void descendAll(const CycleSetup& setup, const std::vector<PairProof>& proofs, Deadline deadline,
                std::vector<SeenPair>& seen);

/// Goes on with proofs on all cores, with ever more cells for each, until each is done or has
/// visited `most_cells`, or the deadline is over. Every proof depends on itself alone, so it comes
/// to the same end on any number of threads, if the deadline does not cut it off.
/// @param progress gets the number of proofs that are done, one call at a time; may be empty
void proveAll(const CycleSetup& setup, std::size_t most_cells, Deadline deadline,
              const std::function<void(std::size_t)>& progress, std::vector<PairProof>& proofs);

}  // namespace collision_monitor
