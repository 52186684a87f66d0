// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/gjk.h"

namespace collision_monitor {

/// Runs GJK for a pair with a cylinder. On a curved side or rim GJK takes ever smaller steps
/// towards the closest points. After 4, 8, 16, ... steps it pauses, and two shorter ways are tried:
/// - Along an axis of a core, each core may end in a flat part or a line: a cap, a face, a side. If
///   these two parts face each other, the gap along the axis is the distance. Robots are full of
///   such pairs: their axes are parallel or at right angles.
/// - Newton's method starts at the closest points so far, as at a warm start. Its points count only
///   if support planes prove their distance.
///
/// Frames: A's. Error: as GjkResult. Changes `search.warm` in any case.
/// @param found the state of GJK at the end
/// @param measured the answer, if a shorter way found one
/// @return whether one did
/// @pre pair.isSmooth()
bool searchRound(ConvexPair& pair, ConvexSearch& search, GjkResult& found,
                 SignedDistance& measured) noexcept;

}  // namespace collision_monitor
