// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// Measures a core against the half space z <= 0 of another frame: the height of its lowest point.
/// The point on the core is the middle of all lowest points.
///
/// Frames: world.
/// Error: a few ulps of the lengths. Slopes below kParallel count as level.
SignedDistance distanceToHalfSpace(const ConvexCore& core, const Pose& world_from_core,
                                   const Pose& world_from_half_space) noexcept;

}  // namespace collision_monitor
