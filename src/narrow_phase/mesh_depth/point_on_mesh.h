// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// The point of a surface that is nearest to some point.
struct PointOnMesh {
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};
  std::uint32_t triangle{kNone};
  std::uint32_t visits{0};  ///< nodes opened and triangles measured, but for the first
};

/// When a search for the nearest point may stop early. The defaults never do.
struct PointQueryLimits {
  double cutoff{0.0};  ///< [m] >= 0. Once a point this near is found, none nearer is looked for.
  /// [m] Points this far or farther are not looked for.
  double stop_beyond{std::numeric_limits<double>::infinity()};
};

/// Frames: the mesh's. Error: some ulps of the coordinates.
/// @param start a triangle to begin with, or none.
/// @return infinitely far and without a triangle where there is nothing within the limits.
PointOnMesh nearestOnMesh(const MeshTree& mesh, const Eigen::Vector3d& point, std::uint32_t start,
                          const PointQueryLimits& limits, MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
