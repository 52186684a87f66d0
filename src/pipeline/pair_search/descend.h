// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/pair_search/pair_proof.h"

namespace collision_monitor {

/// Looks for a state in which two links touch, downhill from a state in which they are near:
/// compass search, which tries a step of each joint to both sides, takes what brings the links
/// nearer, and halves the steps where nothing does.
///
/// The same start gives the same answer on every thread.
/// Source: Kolda, Lewis, Torczon, "Optimization by Direct Search" (2003), section 1.
/// @param state the start; the state that touches where the answer is not `apart`
Touch descend(ProofTools& tools, LinkPairIndex pair, const PairMotion& motion,
              const std::vector<Pose>& world_from_root, JointPositions& state);

}  // namespace collision_monitor
