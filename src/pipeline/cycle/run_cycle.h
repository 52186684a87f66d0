// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

/// Runs one cycle, from poses to events.
namespace collision_monitor {

/// Measures without verdicts what the budget of one cycle may starve. Used where many links become
/// known at once, as at the start: otherwise the next cycle would report contacts of enclosing
/// shapes. Takes the budget of as many cycles as needed, at most 50.
/// @pre as runCycle; objects that rest are where they were in the last cycle
void learnPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// Does before the first cycle what takes long in it: learns all pairs and judges them. Nothing
/// counts as reported, and nothing is known of velocities. @pre as runCycle; new buffers
void prepareFirstCycle(const CycleSetup& setup, const LinkPoses& poses,
                       CycleBuffers& buffers) noexcept;

/// Runs one cycle. The same input and memory give the same bytes, whichever broad phase is used.
/// Neither allocates, locks nor throws.
/// @pre buffers were made for this set-up; poses are sized for its model.
void runCycle(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
