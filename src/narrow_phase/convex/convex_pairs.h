// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "collision_monitor/narrow_phase/convex_distance.h"

/// Signed distances of many convex pairs in one call.
namespace collision_monitor {

/// A pair to measure, and what its last search left.
struct ConvexQuery {
  const ConvexGeometry* a;
  const Pose* world_from_a;
  const ConvexGeometry* b;
  const Pose* world_from_b;
  ConvexWarmStart* warm;
};

/// Measures `count` pairs. answers[i] and the warm start it leaves are those of
/// signedDistanceBetween for queries[i], to the last bit. Pairs that keep their nearest features
/// are proven several at once: polytopes, and cylinders beside a corner, an edge, a sphere or the
/// rim of another cylinder; see docs/performance.md. Pairs that overlap gain nothing.
///
/// Frames, sign, errors and limits: as signedDistanceBetween without a cutoff.
/// @pre no two queries share a warm start; poses are rigid if they are finite.
void signedDistancesBetween(const ConvexQuery* queries, std::size_t count,
                            ConvexWorkspace& workspace, ConvexDistance* answers) noexcept;

}  // namespace collision_monitor
