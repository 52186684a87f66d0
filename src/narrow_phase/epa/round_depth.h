// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// The depth of two overlapping round cores (cylinders or segments) whose axes are not parallel.
///
/// With axes a and b, a unit direction n, p = n . a and q = n . b, the cores overlap along n by
///
///     r_a sqrt(1 - p^2) + l_a |p| + r_b sqrt(1 - q^2) + l_b |q| - c . n,
///
/// The depth is the least overlap. It lies on a kink, where n is an axis or perpendicular to one,
/// or at a smooth place. There the overlap is the support function of a surface, whose lesser
/// radius of curvature is at least the depth, or the place would not be least. That radius comes
/// from two rims, and for nearly parallel axes it is small except close to the axes. If no smooth
/// place can be as low, the kinks have the answer: two axes, and two great circles, on which a
/// function of one variable is first concave and then convex. This is EPA's worst case: if axes
/// nearly coincide, all directions across them are about equally deep.
/// Frames: A's. Error: a few ulps of the lengths.
/// Source: worked out here; the radii of curvature as in Schneider, "Convex Bodies: The
/// Brunn-Minkowski Theory" (1993), section 2.5.
/// @param at_least [m] > 0, a lower bound of the depth.
/// @return false if the pair is of another kind, or a smooth place could be lower than the kinks.
bool depthOfRound(const ConvexPair& pair, double at_least, SignedDistance& cores) noexcept;

}  // namespace collision_monitor
