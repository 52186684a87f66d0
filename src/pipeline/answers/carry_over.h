// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Copies the speed scale, and the reported verdicts of link pairs that both set-ups check. Links
/// are the same if their tf frames are the same.
/// @return pairs of `from` whose reported verdict is not clear and that `to` does not check.
std::vector<LinkPairIndex> carryOver(const CycleSetup& from, const PairMemory& reported,
                                     const CycleSetup& to, PairMemory& memory);

}  // namespace collision_monitor
