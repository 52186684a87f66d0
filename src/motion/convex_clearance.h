// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "motion/relative_motion.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// How far two convex geometries provably stay apart during a motion: [m], a lower bound up to
/// rounding; minus infinity if nothing is proven.
///
/// The plane across their nearest points in the middle parts them. Its normal is fixed to A. Where
/// points move evenly, the gap along the normal is concave in time, so it is least at an end of the
/// interval. Support functions find it at both ends.
///
/// Frames: world, in the middle of the interval.
/// Limits: nothing is proven of a half space that is B and turns.
/// @param motion of B seen from A
double clearanceOf(const PlacedConvex& a, const PlacedConvex& b, const RelativeMotion& motion,
                   ConvexSearch& search) noexcept;

}  // namespace collision_monitor
