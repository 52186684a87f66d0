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

/// The same for two set-ups of the same links, and fast enough for the cycle's thread: also keeps
/// the last poses, so that contacts since the last cycle are still found.
/// @pre both memories are sized for their set-ups; links have the same ids
/// @param dropped has room for every pair of `from`
void carryOverSameLinks(const CycleSetup& from, const PairMemory& reported, const CycleSetup& to,
                        PairMemory& memory, std::vector<LinkPairIndex>& dropped) noexcept;

}  // namespace collision_monitor
