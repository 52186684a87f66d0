// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/sweep_pairs.h"

/// The boxes that the broad phase sees.
namespace collision_monitor {

/// Boxes grown by `reach` / 2 [m], so that bodies within reach of each other have boxes that meet.
void boundBodies(const CycleSetup& setup, const BodyPoses& body_poses, double reach,
                 BodyBounds& bounds) noexcept;

/// Makes each box hold its body on the whole way.
/// @pre `bounds` are those of boundBodies with this `reach`.
void sweepBounds(const CycleSetup& setup, const BodyPoses& body_poses, const SweepWork& work,
                 double reach, BodyBounds& bounds) noexcept;

/// Grows the boxes by as far as their bodies can get in `duration` [s], so that bodies that may be
/// within reach by then have boxes that meet, too. What all links share, the first robot's root
/// moving with them, counts for nothing. Links of parts that float share nothing with the others.
void growBounds(const CycleSetup& setup, const LinkPoses& poses, double duration,
                BodyBounds& bounds) noexcept;

}  // namespace collision_monitor
