// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/support_plane.h"

namespace collision_monitor {

/// Moves the witness points of faces or edges that face each other to the middle of their common
/// part, the centroid of a polygon. All points over it are equally near. The middle does not jump
/// from corner to corner while the cores slide.
///
/// Frames: that of the poses.
/// Error: features count as level up to a sine of 1e-11. Points leave their cores by at most that
/// times the sizes. Distance and normal do not change.
/// Limits: faces with more than 16 corners, and discs, lose some of their rim.
/// @param cores an exact answer.
void centerOnPatch(const PlacedCore& a, const PlacedCore& b, SignedDistance& cores) noexcept;

/// The same with support planes that are already known.
/// @param planes across the normal of `cores`.
/// @return false if there is no such middle; the points then stay.
bool centerOnPatch(const PlacedPair& pair, const SupportPlanes& planes,
                   SignedDistance& cores) noexcept;

}  // namespace collision_monitor
