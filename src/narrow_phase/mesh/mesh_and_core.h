// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "geometry/constants.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/mesh/nearest_search.h"

/// What queries about a mesh and a solid shape share: the search for the nearest triangle.
namespace collision_monitor {

/// A mesh and a core, seen from the core.
struct MeshAndCore {
  const MeshTree& mesh;
  Pose core_from_mesh;
  Pose mesh_from_core;
  ConvexCore core;
  Eigen::AlignedBox3d box;  ///< about the core
  PlacedBound bound;        ///< of the core, for nodes of the mesh
  double radius;            ///< [m] of the shape about its core
  double rounding;          ///< [m] cores this near touch the surface
};

MeshAndCore makeMeshAndCore(const PlacedMesh& a, const InflatedCore& b,
                            const Pose& world_from_b) noexcept;

/// A point of the core; a hull need not hold the origin of its frame.
Eigen::Vector3d anyPointOf(const ConvexCore& core) noexcept;

/// A triangle of the mesh in the frame of the core.
Triangle triangleInCore(const MeshAndCore& pair, std::uint32_t triangle) noexcept;

/// @param bounds the node pair of the triangle, if the search has a front.
void measureTriangle(const MeshAndCore& pair, std::uint32_t triangle,
                     const MeshQueryMemory::NodePair& bounds, NearestSearch& search) noexcept;

/// Chooses a node of the mesh to open against the core, as choose() of two meshes.
void choose(const MeshAndCore& pair, Slot slot, OpenedPair& opened) noexcept;

/// Branch and bound from the root. @param cutoff [m] a core this near ends the search.
void searchFromRoot(const MeshAndCore& pair, double cutoff, std::uint32_t visit_budget,
                    MeshQueryMemory& memory, NearestSearch& search) noexcept;

/// Whether the core is inside the mesh, and how far that holds.
struct CoreInMesh {
  bool is_inside{false};
  double hold{kInfinity};  ///< [m] of a point that is inside, else the least of all points
  std::uint32_t visits{0};
};

/// Looks for a point of the core inside the mesh. A closed mesh that the core does not cross holds
/// all of the core or nothing.
CoreInMesh lookInside(const MeshAndCore& pair, const NearestSearch& search, MeshQueryMemory& memory,
                      bool asks_hold = true) noexcept;

/// Measures the surface of a mesh and a half space, as distanceBetween.
MeshDistance measureHalfSpace(const PlacedMesh& a, const Pose& world_from_half_space) noexcept;

}  // namespace collision_monitor
