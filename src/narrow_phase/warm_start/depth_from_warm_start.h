// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {

/// Keeps the polytope that a search for the depth has grown, if it has few enough faces.
void cachePolytope(const ConvexWorkspace& grown, ConvexWarmStart& warm) noexcept;

/// Measures how deep two polytopes overlap by the one that the last search has grown inside of
/// their difference. Its corners are points of the difference wherever the cores are now. Where
/// every face still looks away from the origin, a ball as wide as the nearest one is far lies
/// inside; where that face is one of the difference's own, which its support plane proves, the
/// depth is its distance. Where a corner lies beyond that face, the polytope grows by it as EPA's
/// does; its surface stays closed, which with faces that look away is all that the ball needs.
///
/// Frames: the world's. Error: as a search that is settled, see Penetration.
/// Limits: of polytopes that do more than touch; the others are left to the search.
/// @return nothing when the search has to decide; always if a pose is not
/// finite.
std::optional<WarmStartDistance> depthFromWarmStart(const PlacedPair& pair,
                                                    ConvexWarmStart& warm) noexcept;

}  // namespace collision_monitor
