// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/gjk/support_plane.h"

namespace collision_monitor {

struct WarmStartDistance {
  SignedDistance cores;
  bool is_level;  ///< other points are as near: centerOnPatch() finds the middle of them
};

/// Measures two cores by the corners that were nearest in the last search, if a support plane
/// proves that they still are: one look at the neighbours of a corner each. Where it does not, the
/// corners that are farther towards each other are tried, a few times. Most pairs of a moving robot
/// are settled so, near and far.
///
/// Frames: the world's. Error: as a search that is settled, see GjkResult.
/// Limits: of polytopes that are apart; the others are left to the search. Cylinders and overlaps
/// have ways of their own.
/// @return nothing when the search has to decide; always if a pose is not
/// finite.
/// Source: Lin, Canny, "A fast algorithm for incremental distance calculation" (1991), for the
/// features of the last query and the look at their neighbours alone; departs from it in the proof
/// by planes, as in gjk.h.
std::optional<WarmStartDistance> distanceFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept;

}  // namespace collision_monitor
