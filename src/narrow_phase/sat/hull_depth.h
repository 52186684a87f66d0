// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/sat/hull_axes.h"

/// Depth of two hulls by their separating axes.
namespace collision_monitor {

/// As separateHulls, in A's frame.
/// @param enough [m] a face that separates this much ends the search.
HullAxis bestAxis(const ConvexHull& a, const ConvexHull& b, const Pose& a_from_b,
                  double cutoff = std::numeric_limits<double>::infinity()) noexcept;

/// Whether both are hulls with so few faces that their axes are told quicker than GJK and EPA tell
/// the depth.
bool haveFewFaces(const ConvexPair& pair) noexcept;

/// How deep two hulls overlap by the axis that separates them most, and where: under a face the
/// other's vertex, between edges the ends of their common perpendicular, over parallel faces and
/// edges the middle of what they share. The support planes across the axis and points that lie on
/// both features prove the answer.
///
/// Frames: A's. Error: rounding.
/// @return false, with `found` as it was, where that is not proven and where the hulls are apart or
/// do no more than touch: a search has to tell.
/// @pre haveFewFaces(pair).
bool depthOfHulls(ConvexPair& pair, SignedDistance& found) noexcept;

}  // namespace collision_monitor
