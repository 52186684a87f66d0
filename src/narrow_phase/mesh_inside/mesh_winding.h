// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// How many times a surface goes around a point.
struct WindingNumber {
  double value{0.0};
  double error{0.0};       ///< a bound; infinite for a point that is not finite
  std::uint32_t parts{0};  ///< of the surface: work, of about 10 ns each
};

/// Work of a block of a rim, as WindingNumber::parts.
constexpr std::uint32_t kPartsPerBlock = 3;

/// Adds the solid angle of the rim to the crossings of a line of sight. This is exact but for
/// rounding: away from the rim the error is 1e-9. A long rim is split into parts until the error is
/// at most `error` (1e-9 can always be reached): near parts by their solid angles, far parts by
/// their moments.
///
/// Frames: the mesh's. Time: that of one line of sight and of the sides of the rim. At the few
/// points where every line of sight is in doubt, it is that of all triangles.
/// Error: the sum of triangles is off by more than 1e-9 beside slivers: by up to 1e-5 at 1e-6 of
/// the mesh's size from the surface, by less than 1e-9 from 1e-3 on. Source: as windingOf.
/// Departure: fixes the error in place of a ratio of distance and size.
/// @pre the mesh has an OpenSurface.
WindingNumber windingNumber(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept;

/// The same, but stops once it is certain whether the number exceeds `limit` in size. Most points
/// take a tenth of the time.
/// @param share the error of a number below the limit is at most this share of what is left to the
/// limit, or `error`
WindingNumber windingByLimit(const MeshTree& tree, const Eigen::Vector3d& point, double limit,
                             double error, MeshQueryMemory& memory, double share = 1.0) noexcept;

}  // namespace collision_monitor
