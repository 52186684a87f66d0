// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/sweep_pairs.h"

/// The boxes that the broad phase uses.
namespace collision_monitor {

/// Makes boxes grown by `reach` / 2 [m]: bodies within `reach` of each other have boxes that meet.
void boundBodies(const CycleSetup& setup, const BodyPoses& body_poses, double reach,
                 BodyBounds& bounds) noexcept;

/// Makes each box hold its body during the whole motion since the last cycle.
/// @pre `bounds` are those of boundBodies with this `reach`.
void sweepBounds(const CycleSetup& setup, const BodyPoses& body_poses, const SweepWork& work,
                 double reach, BodyBounds& bounds) noexcept;

/// The twist of the first robot's root, which its part shares; zero if it is not known.
Twist sharedTwist(const CycleSetup& setup, const LinkVelocities& velocities) noexcept;

/// [m] How far a body may travel in `duration` [s]. NaN: not known.
/// @param shared is left out of the motion of bodies in the part of the first robot's root
double travelAhead(const CycleSetup& setup, const LinkPoses& poses, const Body& body,
                   const Twist& shared, double duration) noexcept;

/// Finds how far bodies can travel in `duration` [s]. Velocities are relative to the first robot's
/// root, since shared motion changes no distance. Parts without this root use their own frame;
/// where CycleSetup::carried has objects, all do, so that bounds of objects at rest stay the same.
void lookAhead(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
               double duration, BodyBounds& bounds) noexcept;

/// Grows the boxes by how far their bodies can travel, so that bodies that may be within `reach` by
/// then have boxes that meet.
void growBounds(const BodyPoses& body_poses, BodyBounds& bounds) noexcept;

}  // namespace collision_monitor
