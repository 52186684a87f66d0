// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"

/// Why a pair is checked or not, and by which limits.
namespace collision_monitor {

/// The place in setup.link_pairs; its size if one of the links has no shapes, both are the same, or
/// both are objects that form no pair.
std::size_t findLinkPair(const CycleSetup& setup, LinkId a, LinkId b) noexcept;

/// "ignored: a rule for pairs (rules.yaml line 3, rule 2)"; names lines of SRDFs too.
std::string reasonOf(const CycleSetup& setup, const LinkPair& pair);

/// Why two objects form no pair. @param groups findRigidGroups of the model
std::string reasonOfObjects(const std::vector<LinkId>& groups, LinkId a, LinkId b);

/// Where the rule stands that sets each limit of a pair, by kLimitFields; empty: a common limit.
std::vector<std::string> limitPlaces(const CycleSetup& setup, const LinkPair& pair);

/// The limits of a pair, whether it is checked or not.
const Limits& limitsOf(const CycleSetup& setup, const LinkPair& pair) noexcept;

}  // namespace collision_monitor
