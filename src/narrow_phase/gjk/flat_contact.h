// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/support_plane.h"

namespace collision_monitor {

/// Where faces or edges of two cores face each other, all points over what they share are as near:
/// moves the witness points to the middle of it, the centroid of a polygon, so that they do not
/// jump from corner to corner while the cores slide.
///
/// Frames: that of the poses.
/// Error: features count as level up to a sine of 1e-11, and points leave their cores by no more
/// than that times the sizes. Distance and normal stay.
/// Limits: of faces with more than 16 corners, and of discs, some of the rim is left out.
/// @param cores an exact answer.
void centerOnPatch(const PlacedCore& a, const PlacedCore& b, SignedDistance& cores) noexcept;

/// The same by planes that are known already.
/// @param planes across the normal of `cores`.
/// @return whether there is such a middle; false leaves the points.
bool centerOnPatch(const PlacedPair& pair, const SupportPlanes& planes,
                   SignedDistance& cores) noexcept;

}  // namespace collision_monitor
