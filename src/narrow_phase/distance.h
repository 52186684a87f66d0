// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

namespace collision_monitor {

/// Signed distance, witness points and normal of two posed shapes of the core + radius family. See
/// signed_distance.h for frames and sign. Each pair of cores has its file:
/// `distance_segment_box.cpp` and so on.
///
/// Error: at most 1e-12 m for lengths from 1 mm to 10 m and distances up to 10 m, measured in
/// docs/accuracy.md.
/// Limits: parallel, concentric and zero-size shapes are legal. If the normal is not unique, it is
/// one that realises the distance, always the same. If faces or edges are parallel, the points lie
/// in the middle of their common part; if nearly parallel, perhaps at either end of it.
/// Source: Ericson, "Real-Time Collision Detection" (2005), chapters 5.1 and 4.4; Gottschalk, Lin,
/// Manocha, "OBBTree" (1996). Departures are named in src/narrow_phase.
/// @pre poses are finite and rigid.

SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const Sphere& b,
                               const Pose& world_from_b) noexcept;
SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const Capsule& b,
                               const Pose& world_from_b) noexcept;
SignedDistance distanceBetween(const Sphere& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept;
SignedDistance distanceBetween(const Capsule& a, const Pose& world_from_a, const Capsule& b,
                               const Pose& world_from_b) noexcept;
SignedDistance distanceBetween(const Capsule& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept;
SignedDistance distanceBetween(const RoundedBox& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept;

/// Measures any pair of the family. A box counts as a rounded box of radius 0. A pair in the other
/// order is measured in the canonical one, and the answer swapped.
SignedDistance distanceBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                               const Pose& world_from_b) noexcept;

}  // namespace collision_monitor
