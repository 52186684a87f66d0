// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Makes `moved` hold everything that the set-up places.
void moveAll(const CycleSetup& setup, MovedParts& moved);

/// Leaves objects of CycleSetup::carried out of `body_poses.moved` once they have rested for so
/// many cycles that nothing kept of them would change. Objects of a floating part always stay in.
/// @pre poses of objects are those of objectPoses: one carrier gives all of its objects their
/// status, part and velocity.
void findResting(const CycleSetup& setup, const LinkPoses& poses, LastPoses& last,
                 BodyPoses& body_poses) noexcept;

/// What findResting knows of objects that have rested for long with this twist.
Rest settledRest(const Twist& twist) noexcept;

/// Whether the twist is none but for what a filter leaves of a motion.
bool isFaded(const Twist& twist) noexcept;

}  // namespace collision_monitor
