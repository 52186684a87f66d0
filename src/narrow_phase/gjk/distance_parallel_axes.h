// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// True for a cylinder or a segment.
bool isRound(const ConvexCore& core) noexcept;

/// Measures two cylinders with parallel axes. A segment is a cylinder of radius 0. A point also has
/// length 0, and its axis is parallel to any.
///
/// Such a pair is a pair of discs times a pair of intervals, and these give gap and depth. GJK
/// would only approach them. EPA would not reach them if the axes coincide, because every direction
/// across them is equally deep.
/// Frames: A's. For flat contacts the points lie in the middle of the common part.
/// Error: a few ulps of the lengths. Axes within kParallel count as parallel.
/// @return false if the pair is of another kind.
bool distanceOfParallelAxes(const ConvexPair& pair, SignedDistance& cores) noexcept;

}  // namespace collision_monitor
