// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Makes all that cycles keep of carried objects as after a long rest at these poses. The first
/// cycle can then leave out those that have settled, see settledRest.
/// @pre the buffers have seen one cycle, at these poses, in which everything counted as moved
void settleObjects(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
