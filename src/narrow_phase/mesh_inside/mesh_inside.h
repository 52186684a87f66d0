// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// True if the closed surface goes around the point, at least once and in either direction.
///
/// Frames: the mesh's. Error: as crossingsAbove, which looks along z.
/// @pre the mesh is closed.
bool isInside(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory) noexcept;

/// Whether a point is inside a mesh, and how far that holds.
struct PointInMesh {
  bool is_inside{false};
  /// [m] How far the point may travel without crossing the surface before that can change. Infinite
  /// for closed meshes.
  double hold{std::numeric_limits<double>::infinity()};
  std::uint32_t visits{0};  ///< of an open surface, converted to nodes
};

/// The same for any mesh. The inside of an open mesh is the part of its hull, or of the box and the
/// slabs around it, with a winding number above 1/2 in size. Near a hole it ends where half of all
/// directions lead out. A point that is not finite is outside, with a hold of 0.
///
/// Frames: the mesh's. Error: where the rim is long, points with a number between 1/2 and 0.52 may
/// count as outside. Points with a number of 1/2 or less never count as inside.
/// Source: Jacobson, Kavan, Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized
/// Winding Numbers" (2013), for the threshold. `hold`: off the surface the gradient of the winding
/// number is that of the rim's solid angle. By Biot and Savart it is at most the rim's length over
/// 4 pi times the squared distance; docs/decisions/inside-of-open-meshes.md.
/// @param asks_hold also finds `hold`, which takes most of the time; else it means nothing.
/// @pre the mesh has an inside.
PointInMesh lookInside(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory,
                       bool asks_hold = true) noexcept;

/// Whether `is_beyond` holds for a face of an open surface's hull: nothing beyond one is inside.
/// @param last the face that was found for another point, or nullptr; is tried first and replaced
template <class IsBeyond>
bool isBeyondAnyFace(const OpenSurface& open, const ConvexHull::Face*& last,
                     const IsBeyond& is_beyond) noexcept {
  if (last != nullptr && is_beyond(*last)) {
    return true;
  }
  const auto found = std::find_if(open.hull.begin(), open.hull.end(), is_beyond);
  last = found == open.hull.end() ? last : &*found;
  return found != open.hull.end();
}

/// Proves that a point is outside, and stays outside while it travels by at most `travel` [m] and
/// does not cross the surface. It takes less time than PointInMesh::hold, proves no longer ways,
/// and no ways shorter than leastHold.
/// @param visits receives the work
/// @pre the mesh has an inside.
bool staysOutside(const MeshTree& tree, const Eigen::Vector3d& point, double travel,
                  MeshQueryMemory& memory, std::uint32_t& visits) noexcept;

}  // namespace collision_monitor
