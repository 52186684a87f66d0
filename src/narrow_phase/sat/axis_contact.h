// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/sat/separating_axes.h"

namespace collision_monitor {

/// Looks for the two points that realise the largest separation: on a face and the feature of
/// the other box that faces it, or on two crossing edges. Where they exist, the largest
/// separation is the signed distance; for flat contacts the points lie over the center of the
/// patch that the features share.
///
/// Frames: A's. Of axes that tie within rounding, faces come first.
/// @return false when no such points exist: the boxes are apart and a corner is nearest.
bool contactAlongAxis(const BoxPair& pair, const Separations& separations,
                      SignedDistance& cores) noexcept;

/// As above for boxes that touch or overlap, where such points always exist: rounding may put
/// them off their features by some ulps, and the pair that is least off is taken.
SignedDistance nearestContact(const BoxPair& pair, const Separations& separations) noexcept;

}  // namespace collision_monitor
