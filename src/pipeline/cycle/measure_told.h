// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Measures pairs that refinePairs left with a shortfall, where somebody is told their distance:
/// those that may be the nearest, the soonest to touch or the slowest of a robot, that change their
/// verdict, or are nearer than RefineWork::told_below.
/// Measures elements that refinePairs skipped, if they may be the soonest or the slowest, change a
/// verdict by time, or close within the stop distance.
/// Within the budget, every other pair with a shortfall is proven to be farther, and every other
/// pair to touch later and to ask for a larger scale.
/// @pre findClosings was called. Pairs that are measured get their closing speeds anew.
void measureTold(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
