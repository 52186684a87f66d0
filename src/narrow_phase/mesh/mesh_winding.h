// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// How many times a surface goes around a point.
struct WindingNumber {
  double value{0.0};
  double error{0.0};        ///< a proven bound
  std::uint32_t visits{0};  ///< parts of the surface looked at
};

/// From moments of what is far and solid angles of what is near. Parts are taken smaller until the
/// error is not above `error`, which 1e-9 can always be.
///
/// Frames: the mesh's. Time: of the order of the tree's depth.
/// Source: as windingOf; there a ratio of distance and size is fixed and the error measured.
/// @pre the mesh has an OpenSurface.
WindingNumber windingNumber(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept;

/// The same, or until there is no doubt whether the size of the number is above 1/2: of most points
/// a tenth of the time.
WindingNumber windingByHalf(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
