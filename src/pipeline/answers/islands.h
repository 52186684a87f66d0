// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Groups links that are in contact, directly or through others. Numbers the groups 1, 2, ... in
/// order of their first link. Reads events.verdicts, writes the islands.
///
/// Source: union-find with path halving; Tarjan and van Leeuwen, "Worst-case analysis of set union
/// algorithms" (1984). The smaller id becomes the root, so numbering needs no sort.
void findIslands(const std::vector<CheckedLinkPair>& checked, PairEvents& events) noexcept;

}  // namespace collision_monitor
