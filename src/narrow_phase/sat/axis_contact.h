// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/sat/separating_axes.h"

namespace collision_monitor {

/// Finds the two points that realise the largest separation: on a face and the feature of the other
/// box that faces it, or on two crossing edges. If they exist, the largest separation is the signed
/// distance. For flat contacts the points lie over the center of the common patch.
///
/// Frames: A's. If axes tie within rounding, faces come first.
/// @return false if there are no such points: the boxes are apart and a corner is nearest.
bool contactAlongAxis(const BoxPair& pair, const Separations& separations,
                      SignedDistance& cores) noexcept;

/// The same for boxes that touch or overlap, which always have such points. Rounding may put them a
/// few ulps off their features; the pair that is least off is taken.
SignedDistance nearestContact(const BoxPair& pair, const Separations& separations) noexcept;

}  // namespace collision_monitor
