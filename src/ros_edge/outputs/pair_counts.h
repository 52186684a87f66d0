// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "collision_monitor/model/pair_rules.h"

namespace collision_monitor {

/// Number of link pairs by PairReason.
using PairCounts = std::array<std::size_t, 12>;

PairCounts countPairs(const std::vector<LinkPair>& pairs);
std::size_t countOf(PairReason reason, const PairCounts& counts);

/// The reasons that exclude pairs from checks.
constexpr std::array<PairReason, 9> kReasonsNotToCheck{PairReason::same_rigid_group,
                                                       PairReason::adjacent,
                                                       PairReason::disabled_by_srdf,
                                                       PairReason::default_overlap,
                                                       PairReason::ignored_by_user,
                                                       PairReason::ignored_by_rule,
                                                       PairReason::muted,
                                                       PairReason::touch_link,
                                                       PairReason::two_objects};

/// Text to follow a number of pairs: "that meet at a joint".
const char* whyNotText(PairReason reason) noexcept;

/// "; not checked: 2 that meet at a joint, 1 hidden by ignore_pairs"; empty if all are.
std::string notCheckedText(const PairCounts& counts);

/// "; 3 pairs of links are muted for another 12 s", or nothing.
/// @param time [s] 0: it is over, but another change keeps the rules from ending
std::string muteText(std::size_t pairs, double time);

}  // namespace collision_monitor
