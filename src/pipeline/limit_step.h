// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/sweep_pairs.h"

namespace collision_monitor {

/// [m] By LinkPairIndex: how thick two bodies are together where they are thinnest, the least of
/// all bodies of two links. Two without thickness overlap at no time, so they do not count.
std::vector<double> thicknessOfPairs(const CycleSetup& setup);

/// Fills work.step for a step of work.elapsed.
///
/// What passes through something in a step comes farther, seen from it, than both are thick. Where
/// poses alone are looked at, links come as far as their twists say. Where the way between two
/// cycles is looked at, only what leaves their screws is unseen: an even acceleration that changes
/// the way of a step by w against that of the last one bends the path by w / 8.
/// Error: estimates, for the twists of one time stand for a whole step.
void limitStep(const CycleSetup& setup, SweepWork& work) noexcept;

}  // namespace collision_monitor
