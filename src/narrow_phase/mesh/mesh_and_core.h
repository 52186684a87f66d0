// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "geometry/constants.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/mesh/nearest_search.h"

/// What questions about a mesh and a solid shape share: the search for the nearest triangle.
namespace collision_monitor {

/// A mesh and a core, seen from the core.
struct MeshAndCore {
  const MeshTree& mesh;
  Pose core_from_mesh;
  Pose mesh_from_core;
  ConvexCore core;
  Eigen::AlignedBox3d box;  ///< of the core
  PlacedBound bound;        ///< of the core, for nodes of the mesh
  double radius;            ///< [m] of the shape about its core
  double rounding;          ///< [m] a core this near touches the surface
};

MeshAndCore makeMeshAndCore(const PlacedMesh& a, const InflatedCore& b,
                            const Pose& world_from_b) noexcept;

/// A point of the core; a hull need not hold the origin of its frame.
Eigen::Vector3d anyPointOf(const ConvexCore& core) noexcept;

/// A triangle of the mesh in the frame of the core.
Triangle triangleInCore(const MeshAndCore& pair, std::uint32_t triangle) noexcept;

/// @param bounds where the triangle hangs, if the search has a front.
void measureTriangle(const MeshAndCore& pair, std::uint32_t triangle,
                     const MeshQueryMemory::NodePair& bounds, NearestSearch& search) noexcept;

/// A node of the mesh and the core: as of two meshes.
void choose(const MeshAndCore& pair, Slot slot, OpenedPair& opened) noexcept;

/// Branch and bound from the root. @param enough [m] cores that near end the search.
void searchFromRoot(const MeshAndCore& pair, double cutoff, std::uint32_t visit_budget,
                    MeshQueryMemory& memory, NearestSearch& search) noexcept;

/// How the core lies in the inside of the mesh.
struct CoreInMesh {
  bool is_inside{false};
  double hold{kInfinity};  ///< [m] as of a point that is inside, or the least of all that are not
  std::uint32_t visits{0};
};

/// A closed mesh that is not crossed holds all of the core or nothing.
CoreInMesh lookInside(const MeshAndCore& pair, const NearestSearch& search, MeshQueryMemory& memory,
                      bool asks_hold = true) noexcept;

/// Of the surface of a mesh and a half space, as distanceBetween.
MeshDistance measureHalfSpace(const PlacedMesh& a, const Pose& world_from_half_space) noexcept;

}  // namespace collision_monitor
