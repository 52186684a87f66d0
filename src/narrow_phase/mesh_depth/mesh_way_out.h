// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// A translation of B that separates A and B.
struct WayOut {
  double length{std::numeric_limits<double>::infinity()};  ///< [m] at most 0 if they are apart
  Eigen::Vector3d direction{Eigen::Vector3d::UnitX()};     ///< unit, world frame
};

/// Finds the shortest translation that pulls one mesh off the other along the line of centers, an
/// axis of either, or `direction`, which may be the normal of the deepest corner (depthOf). The
/// depth of the solids is at most this, and may be far less if one hooks into the other. The depth
/// of meshes that are not convex takes more time than a cycle has.
///
/// Error: 1e-12 m. A pose that is not finite gives an infinite length.
/// @param direction unit.
WayOut wayOut(const PlacedMesh& a, const PlacedMesh& b, const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
