// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// The depth of two overlapping round cores, cylinders or segments, whose axes are not parallel.
///
/// Along a unit direction n, with a and b the axes, p = n . a and q = n . b, the cores overlap by
///
///     r_a sqrt(1 - p^2) + l_a |p| + r_b sqrt(1 - q^2) + l_b |q| - c . n,
///
/// and the depth is its least value. That lies on a kink, where n is an axis or perpendicular to
/// one, or where the function is smooth; there it is the support function of a surface whose lesser
/// radius of curvature is no smaller than the depth, or it would not be least. Two rims make that
/// radius, and for axes that are nearly parallel it is small except close to the axes. So where it
/// can be ruled out that a smooth place is as low, the kinks have the answer: two axes, and two
/// great circles, on which a function of one variable is first concave and then convex. This is
/// what EPA is worst at: axes that nearly coincide leave all directions across them about equally
/// deep.
/// Frames: A's. Error: some ulps of the lengths.
/// Source: worked out here; the radii of curvature as in Schneider, "Convex Bodies: The
/// Brunn-Minkowski Theory" (1993), section 2.5.
/// @param at_least [m] > 0, what is known of the depth.
/// @return false when the pair is not of this kind or a smooth place could be lower than what the
/// kinks say.
bool depthOfRound(const ConvexPair& pair, double at_least, SignedDistance& cores) noexcept;

}  // namespace collision_monitor
