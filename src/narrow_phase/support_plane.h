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

PlacedPair makePlacedPair(const PlacedCore& a, const PlacedCore& b) noexcept;

/// Whether the support planes across `normal` (unit, from A to B) prove a distance or, if it is
/// negative, a depth: that their gap is this, up to `tolerance`.
/// @return false also where faces or edges are level, and other points might do as well.
bool isProven(const PlacedPair& pair, const Eigen::Vector3d& normal, double distance,
              double tolerance) noexcept;

PlacedCorners place(const ConvexWarmStart::Ends& ends, const PlacedPair& pair) noexcept;

/// The corners that are nearest along `normal`: the farthest of A, and of B against it.
ConvexWarmStart::Ends supportEnds(const PlacedPair& pair, const Eigen::Vector3d& normal) noexcept;

}  // namespace collision_monitor
