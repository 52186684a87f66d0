// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/support_plane.h"

namespace collision_monitor {

struct WarmStartDistance {
  SignedDistance cores;
  bool is_level;  ///< other points are as near; centerOnPatch() finds their middle
};

/// Measures two cores by the corners that were nearest in the last search, if a support plane
/// proves that they still are: one look at the neighbors of each corner. Otherwise it tries corners
/// that are farther towards each other, a few times. This settles most pairs of a moving robot,
/// near and far.
///
/// Frames: the world's. Error: as a search that is settled, see GjkResult.
/// Limits: polytopes that are apart; others are left to the search. Cylinders and overlaps have
/// functions of their own.
/// @return nothing if the search must decide, as always for a pose that is not finite.
/// Source: Lin, Canny, "A fast algorithm for incremental distance calculation" (1991), for the
/// features of the last query and the look at their neighbors alone. Departure: planes prove the
/// answer, as in gjk.h.
std::optional<WarmStartDistance> distanceFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept;

}  // namespace collision_monitor
