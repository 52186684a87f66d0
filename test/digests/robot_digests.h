// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "digests/digest.h"

/// Digests of what the core answers about one robot. Builds that answer the same have the same
/// digests, whatever their sources look like.
namespace collision_monitor::test {

/// Of enclosing shapes, their overshoot and inner shapes.
Digest digestOfFits(const CycleSetup& setup);

/// Of link pairs, each with the reason why it is checked or not, and of pairs of bodies.
Digest digestOfPairs(const CycleSetup& setup);

/// Of 1,000 cycles at 1 kHz and 1,000 at 50 Hz: distances, verdicts, times, passed contacts.
Digest digestOfCycles(const CycleSetup& setup);

/// Of 64 random states, for both questions, by enclosing shapes and by geometries.
Digest digestOfStates(const CycleSetup& setup);

/// Of a path of 100 way-points, checked until a budget is spent.
Digest digestOfTrajectory(const CycleSetup& setup);

/// Of which pairs can touch, by 500 states and small proofs.
Digest digestOfPairSearch(const CycleSetup& setup);

}  // namespace collision_monitor::test
