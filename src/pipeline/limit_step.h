// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/sweep_pairs.h"

namespace collision_monitor {

/// By LinkId: how thick a link is where it is thinnest, and what holds it.
std::vector<LinkExtent> linkExtents(const CycleSetup& setup);

/// Fills work.step for a step of work.elapsed.
///
/// What passes through something in a step comes farther, seen from it, than both are thick. Where
/// the way between two cycles is not looked at, links may come as far as their twists say. Where it
/// is, only as far as they leave their screws: an even acceleration that changes the way of a step
/// by w against that of the last one bends the path by w / 8.
/// Error: estimates, for the twists of one time stand for a whole step.
void limitStep(const CycleSetup& setup, SweepWork& work) noexcept;

}  // namespace collision_monitor
