// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/twist.h"
#include "motion/conservative_advancement.h"

namespace collision_monitor {

/// [m/s] An upper bound of how fast two bodies in these balls close, whatever points of them are
/// nearest, if the bodies are apart. Below 0 if they part for certain.
///
/// Let n be the direction from A's witness point to B's. Each is in its ball. So the angle between
/// n and the line of centers has at most the sine (radius of A + radius of B) / distance of
/// centers. Seen from A, B's point at p moves by v(p) = v(c) + w x (p - c), for any c. The distance
/// falls by -n . v(p), where p is B's witness point. It may also be A's, because w x n is at right
/// angles to n. So c may be the center of either ball.
///
/// Frames: world. Balls that meet allow every direction.
/// @param b_from_a how B moves, seen from A
double closingBound(const Ball& a, const Ball& b, const Twist& b_from_a) noexcept;

}  // namespace collision_monitor
