// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

/// One cycle, from poses to events.
namespace collision_monitor {

/// Measures what one cycle may have no budget for, and judges nothing: where many links come to be
/// known at once, as at the start, the next cycle would else call contacts of enclosing shapes.
/// Takes the time of as many cycles as that needs, of 50 at most. @pre as runCycle
void learnPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// One cycle: poses in, events out. Same input and memory, same bytes out,
/// whichever broad phase. Neither allocates, locks nor throws.
/// @pre buffers were made for this set-up; poses are sized for its model.
void runCycle(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
