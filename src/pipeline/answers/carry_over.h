// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Takes over the speed scale and, of pairs of links that both set-ups check, what was reported of
/// them. Links are the same if their tf frames are.
/// @return pairs of `from` that were not reported as clear, and that `to` does not check.
std::vector<LinkPairIndex> carryOver(const CycleSetup& from, const PairMemory& reported,
                                     const CycleSetup& to, PairMemory& memory);

}  // namespace collision_monitor
