// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/gjk.h"

namespace collision_monitor {

/// Runs GJK for a pair with a cylinder. Towards the closest points on a curved side or rim GJK
/// takes ever smaller steps. So it pauses after 4, 8, 16, ... steps, and tries to end the search at
/// once:
/// - Faces, sides and edges that are level across an axis of a core and face each other are as far
///   apart as their planes. Robots are full of such pairs: their axes are parallel or at right
///   angles.
/// - Else Newton's method starts at the points found so far, as from a warm start. A plane proves
///   what it finds.
///
/// Frames: A's. Error: as GjkResult.
/// @param found of GJK so far
/// @param measured written if the search ended before GJK did
/// @return whether it did
/// @pre pair.isSmooth()
bool searchRound(ConvexPair& pair, ConvexSearch& search, GjkResult& found,
                 SignedDistance& measured) noexcept;

}  // namespace collision_monitor
