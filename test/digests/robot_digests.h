// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "digests/digest.h"

/// What the core answers about one robot, each part as one digest. Two builds that answer the same
/// have the same digests, whatever their sources look like.
namespace collision_monitor::test {

/// Enclosing shapes, how far they stick out, and inner shapes.
Digest digestOfFits(const CycleSetup& setup);

/// Pairs of links with the reason why they are checked or not, and pairs of bodies.
Digest digestOfPairs(const CycleSetup& setup);

/// 1,000 cycles at 1 kHz and 1,000 at 50 Hz: distances, verdicts, times, contacts between cycles.
Digest digestOfCycles(const CycleSetup& setup);

/// 64 random states, both questions, by enclosing shapes and by the exact geometries.
Digest digestOfStates(const CycleSetup& setup);

/// A path of 100 way-points, followed until a budget is spent.
Digest digestOfTrajectory(const CycleSetup& setup);

/// Which pairs can touch, by 500 states and small proofs.
Digest digestOfPairSearch(const CycleSetup& setup);

}  // namespace collision_monitor::test
