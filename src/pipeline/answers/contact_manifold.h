// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/pipeline/setup.h"
#include "narrow_phase/contact/manifold.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Finds all places where a measured pair has its least distance: between the bodies or, if
/// refined, between the elements.
/// Frames: world.
/// @return nothing if an element is a mesh that is not convex: only the witness points are known.
/// @pre the pair belongs to this set-up, and its links are known.
std::optional<ContactManifold> contactManifold(const CycleSetup& setup, const BodyPoses& body_poses,
                                               const PairDistance& distance) noexcept;

}  // namespace collision_monitor
