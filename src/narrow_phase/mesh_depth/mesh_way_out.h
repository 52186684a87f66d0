// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// A translation of B that separates A and B.
struct WayOut {
  double length{std::numeric_limits<double>::infinity()};  ///< [m] at most 0 where they are apart
  Eigen::Vector3d direction{Eigen::Vector3d::UnitX()};     ///< unit, world frame
};

/// The shortest of the ways on which one mesh can be pulled off the other entirely, along the line
/// of centers, the axes of both, and a direction that the caller has: the normal of the deepest
/// corner (depthOf). The depth of the solids is at most that, and may be far less where one hooks
/// into the other: for meshes that are not convex nobody computes it in a cycle.
///
/// Error: 1e-12 m. A pose that is not finite gives an infinite length.
/// @param direction unit.
WayOut wayOut(const PlacedMesh& a, const PlacedMesh& b, const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
