// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"
#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/broad_phase/sweep_and_prune.h"

namespace collision_monitor {

/// Tests every pair of the table. The reference twin of all others, and the
/// best choice for one arm.
struct BruteForce {};

using BroadPhase = std::variant<BruteForce, SweepAndPrune>;

/// The pairs of the table whose bounds meet, sorted by id; the same from every
/// broad phase. Bodies that are not known stand in no candidate.
/// `candidates` must have room for every pair of the table; nothing is allocated.
void findCandidates(BroadPhase& broad_phase, const BodyBounds& bounds, const PairTable& table,
                    std::vector<PairId>& candidates) noexcept;

}  // namespace collision_monitor
