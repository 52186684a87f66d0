// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/pair_blocks.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// The searches of pair_blocks.h that start from poses of links: bodies are placed when needed.
namespace collision_monitor {

/// For findContact; overlapping shapes are in contact as in checkStates.
ContactDistances contactDistancesOf(const CycleSetup& setup);

/// Fills the rows of placeBodies and nothing else, to the last bit, to measure all pairs of one
/// pose. Ignores parts that float.
/// @pre all known links are in one part
void placeRows(const CycleSetup& setup, const LinkPoses& poses, BodyRows& rows) noexcept;

/// Finds whether any pair is in contact, as placeBodies and findContact of pair_blocks.h do, but
/// places bodies in `rows` only when the search needs them.
/// @pre as placeRows
void findContact(const CycleSetup& setup, const LinkPoses& poses, const ContactDistances& limits,
                 BodyRows& rows, FoundContact& found) noexcept;

}  // namespace collision_monitor
