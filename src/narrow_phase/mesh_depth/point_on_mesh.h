// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// The closest point of a surface to some point.
struct PointOnMesh {
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};
  std::uint32_t triangle{kNone};
  std::uint32_t visits{0};  ///< nodes opened and triangles measured, except the first
};

/// Limits at which a search for the closest point may stop early. The defaults have no effect.
struct PointQueryLimits {
  double cutoff{0.0};  ///< [m] >= 0. A point this near ends the search.
  /// [m] Points this far or farther are not looked for.
  double stop_beyond{std::numeric_limits<double>::infinity()};
};

/// Finds the closest point of a surface. Frames: the mesh's. Error: a few ulps of the coordinates.
/// @param start a triangle to begin with, or none.
/// @return an infinite distance and no triangle if nothing is within the limits.
PointOnMesh nearestOnMesh(const MeshTree& mesh, const Eigen::Vector3d& point, std::uint32_t start,
                          const PointQueryLimits& limits, MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
