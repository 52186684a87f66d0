// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/pipeline/setup.h"
#include "narrow_phase/contact/manifold.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// All the places where a measured pair is as near as it gets: of the bodies or, when it is
/// refined, of the elements.
/// Frames: world.
/// @return nothing where one of the two is a mesh that is not convex: the pair's own points are all
/// that is known.
/// @pre the pair is of this set-up, and known.
std::optional<ContactManifold> contactManifold(const CycleSetup& setup, const BodyPoses& body_poses,
                                               const PairDistance& distance) noexcept;

}  // namespace collision_monitor
