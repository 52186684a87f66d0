// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/convex_pair.h"

namespace collision_monitor {

struct PlacedCore {
  const ConvexCore& core;
  const Pose& world_from_core;
  std::uint32_t& vertex;  ///< where the last climb of a hull ended
};

/// Two cores seen from A's origin, along the world's axes.
struct PlacedPair {
  PlacedCore a;
  PlacedCore b;
  Eigen::Vector3d between;  ///< from A's origin to B's
  double size;              ///< [m] see ConvexPair
};

/// Corners of both cores, and the way from one to the other.
struct PlacedCorners {
  Eigen::Vector3d on_a;        ///< from A's origin, along the world's axes
  Eigen::Vector3d difference;  ///< from there to B's
};

inline PlacedPair makePlacedPair(const PlacedCore& a, const PlacedCore& b) noexcept {
  const Eigen::Vector3d between = b.world_from_core.translation - a.world_from_core.translation;
  return {a, b, between, reachOf(a.core) + reachOf(b.core) + between.norm()};
}

/// Whether the support planes across `normal` (unit, from A to B) prove a distance or, if it is
/// negative, a depth: that their gap is this, up to `tolerance`.
/// @return false also where faces or edges are level, and other points might do as well.
bool isProven(const PlacedPair& pair, const Eigen::Vector3d& normal, double distance,
              double tolerance) noexcept;

inline PlacedCorners place(const ConvexWarmStart::Ends& ends, const PlacedPair& pair) noexcept {
  PlacedCorners placed;
  placed.on_a.noalias() = pair.a.world_from_core.rotation * ends.on_a;
  placed.difference.noalias() = pair.b.world_from_core.rotation * ends.on_b;
  placed.difference += pair.between - placed.on_a;
  return placed;
}

/// The corners that are nearest along `normal`: the farthest of A, and of B against it.
ConvexWarmStart::Ends supportEnds(const PlacedPair& pair, const Eigen::Vector3d& normal) noexcept;

}  // namespace collision_monitor
