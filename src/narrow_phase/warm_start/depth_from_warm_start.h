// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {

/// Keeps the polytope that a search for the depth has grown, if it is small enough.
void cachePolytope(const ConvexWorkspace& grown, ConvexWarmStart& warm) noexcept;

/// Measures how deep two polytopes overlap by the polytope that the last search has grown inside
/// their Minkowski difference. Its corners are points of the difference at any poses. If all faces
/// still look away from the origin, it holds a ball with the distance of the nearest face as
/// radius. If a support plane proves that this is a face of the difference, its distance is the
/// depth. If a corner lies beyond it, the polytope grows by it as in EPA. Its surface stays closed;
/// the ball needs no more than that and faces that look away.
///
/// Frames: the world's. Error: as a search that is settled, see Penetration.
/// Limits: polytopes that do more than touch; others are left to the search.
/// @return nothing if the search must decide, as always for a pose that is not finite.
std::optional<WarmStartDistance> depthFromWarmStart(const PlacedPair& pair,
                                                    ConvexWarmStart& warm) noexcept;

}  // namespace collision_monitor
