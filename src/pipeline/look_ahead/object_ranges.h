// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/look_ahead/walk_link_pairs.h"

/// Activation distances of links and objects. Objects of one carrier move as one rigid body, so one
/// bound holds for all of them.
namespace collision_monitor {

/// Whether a pair is of a robot's link and an object. @param first_of_world see firstOfWorld
inline bool isInRange(LinkId first_of_world, const CheckedLinkPair& pair) noexcept {
  return pair.a < first_of_world && pair.b >= first_of_world;
}

/// By LinkId: of an object, the first that its carrier carries; of others, the link itself.
std::vector<LinkId> firstCarried(const RobotModel& model);

/// Fills the ranges, and the balls about all objects of a carrier.
/// @pre links, balls, thickness and of_limits are filled
void makeObjectRanges(const CycleSetup& setup, ActivationDistances& reaches);

/// Fills the distances of all pairs of ranges, and updates the farthest pairs.
void walkObjectRanges(const WalkQuestion& question, const LinkPoses& poses,
                      ActivationDistances& reaches, Farthest& farthest) noexcept;

}  // namespace collision_monitor
