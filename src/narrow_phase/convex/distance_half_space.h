// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// A core against the half space z <= 0 of another frame: how far its lowest point is above the
/// plane. The point on the core is the middle of all that are lowest.
///
/// Frames: world.
/// Error: some ulps of the lengths. What slopes by less than kParallel counts as level.
SignedDistance distanceToHalfSpace(const ConvexCore& core, const Pose& world_from_core,
                                   const Pose& world_from_half_space) noexcept;

}  // namespace collision_monitor
