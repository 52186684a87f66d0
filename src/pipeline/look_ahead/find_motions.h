// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

/// Finds the screw motions from the last poses to these, and the travel of bodies and elements.
/// @pre body_poses are placed from `poses`.
void findMotions(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
                 const PairMemory& memory, SweepWork& work) noexcept;

/// Stores the poses of links that moved, and whether they are known.
void keepLinks(const LinkPoses& poses, const BodyPoses& body_poses, PlacedLinks& placed) noexcept;

/// The same and their stamp, for the next cycle.
void keepPoses(const LinkPoses& poses, const BodyPoses& body_poses, LastPoses& last) noexcept;

}  // namespace collision_monitor
