// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/twist.h"
#include "motion/conservative_advancement.h"

namespace collision_monitor {

/// [m/s] An upper bound of how fast two bodies in these balls close, whatever points of them are
/// nearest, if the bodies are apart. Below 0 if they part for certain.
///
/// Let n be the direction from A's witness point to B's. Both lie in their balls, so n is within
/// an angle of the line of centers whose sine is the sum of the radii over the distance of the
/// centers. Seen from A, a point p of B moves by v(p) = v(c) + w x (p - c). The distance falls by
/// -n . v(p) at B's witness point p, and also at A's, because w x n is at right angles to n. So c
/// may be the center of either ball.
///
/// Frames: world. Balls that meet allow every direction.
/// @param b_from_a how B moves, seen from A
double closingBound(const Ball& a, const Ball& b, const Twist& b_from_a) noexcept;

}  // namespace collision_monitor
