// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/pair_blocks.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// The searches of pair_blocks.h from the poses of links on: bodies are placed as they are asked
/// for.
namespace collision_monitor {

/// For findContact; shapes that overlap as in checkStates.
ContactDistances contactDistancesOf(const CycleSetup& setup);

/// The rows of placeBodies alone, to the last bit: for those who measure all pairs of one pose.
/// Parts that float are not told apart here.
/// @pre all known links stand in one part
void placeRows(const CycleSetup& setup, const LinkPoses& poses, BodyRows& rows) noexcept;

/// Whether any pair is in contact when the links are in these poses: as placeBodies and then
/// findContact of pair_blocks.h, but bodies are placed in `rows` only as the search comes to them.
/// @pre as placeRows
void findContact(const CycleSetup& setup, const LinkPoses& poses, const ContactDistances& limits,
                 BodyRows& rows, FoundContact& found) noexcept;

}  // namespace collision_monitor
