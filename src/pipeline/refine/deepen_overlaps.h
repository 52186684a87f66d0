// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refinement.h"

namespace collision_monitor {

/// Searches for larger depths of overlaps measured in this cycle. They come last, since no verdict
/// of the cycle depends on them, and take the rest of the share of refinePairs. A cycle tries some
/// points, and at least a few for each pair; others follow in the next cycles.
void deepenOverlaps(const Refinement& all) noexcept;

/// The same for one pair, if it is a measured overlap. @param budget the work of the whole cycle
/// @pre deepenOverlaps was called in this cycle
void deepenOverlap(const Refinement& all, RefineTask& task, std::uint32_t budget) noexcept;

}  // namespace collision_monitor
