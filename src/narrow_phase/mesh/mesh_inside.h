// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/mesh_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// True when the closed surface goes around the point, at least once and in either direction.
///
/// Looks up along z and adds the triangles above the point, each with the sign of its turn.
/// Whether a triangle covers the point is put together from its edges, and two triangles that
/// share an edge take the same answer from it: a line of sight through an edge or a
/// corner is counted right.
/// Frames: the mesh's. Error: points on the surface, within rounding, may get either answer.
/// Source: Sunday, "Inclusion of a Point in a Polygon" (2001), for the signed crossings.
/// @pre the mesh is closed.
bool isInside(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory) noexcept;

/// How a point lies in the inside of a mesh.
struct PointInMesh {
  bool is_inside{false};
  /// [m] How far the point may go without crossing the surface until that can change. Infinite for
  /// closed meshes.
  double hold{std::numeric_limits<double>::infinity()};
  std::uint32_t visits{0};  ///< of an open surface, in the time of nodes
};

/// The same for any mesh. Inside of an open one are the points of its box whose winding number is
/// above 1/2 in size; near a hole that ends where half of all directions lead out.
///
/// Frames: the mesh's. Error: points whose number is above 1/2 by no more than 0.02 may be called
/// outside, and none of another number is called inside.
/// Source: Jacobson, Kavan, Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized
/// Winding Numbers" (2013), for the threshold. `hold`: off its surface the winding number has the
/// gradient of the solid angle of the rim, by Biot and Savart no more than its length over
/// 4 pi times the squared distance; docs/decisions/inside-of-open-meshes.md.
/// @param asks_hold `hold` is wanted, too, which takes most of the time: else it means nothing.
/// @pre the mesh has an inside.
PointInMesh lookInside(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory,
                       bool asks_hold = true) noexcept;

}  // namespace collision_monitor
