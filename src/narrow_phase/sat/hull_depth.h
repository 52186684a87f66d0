// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/sat/hull_axes.h"

/// Depth of two hulls by their separating axes.
namespace collision_monitor {

/// True if both are hulls with so few faces that their axes give the depth faster than GJK and EPA.
bool haveFewFaces(const ConvexPair& pair) noexcept;

/// Measures how deep two hulls overlap along the axis that separates them most. The points are at
/// the other's vertex under a face, at the ends of the common perpendicular of two edges, or in the
/// middle of the common part of parallel faces and edges. The support planes across the axis and
/// points on both features prove the answer.
///
/// Frames: A's. Error: rounding.
/// @return false, with `found` unchanged, if this is not proven or the hulls do not overlap by more
/// than touching: a search must decide.
/// @pre haveFewFaces(pair).
bool depthOfHulls(ConvexPair& pair, SignedDistance& found) noexcept;

}  // namespace collision_monitor
