// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// A cylinder or a segment.
bool isRound(const ConvexCore& core) noexcept;

/// Two cylinders whose axes are parallel; a segment is one of radius 0, a point one of length 0
/// too, whose axis is parallel to any.
///
/// Such a pair is a pair of discs times a pair of intervals, so that gap and depth are those of
/// the one or the other. What GJK would approach, and EPA not reach at all where the axes coincide
/// and every direction across them is equally deep, is exact here.
/// Frames: A's. For flat contacts the points lie in the middle of what is shared.
/// Error: some ulps of the lengths; axes that differ by kParallel count as parallel.
/// @return false when the pair is not of this kind.
bool distanceOfParallelAxes(const ConvexPair& pair, SignedDistance& cores) noexcept;

}  // namespace collision_monitor
