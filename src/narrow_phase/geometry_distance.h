// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "geometry/sphere_tree.h"
#include "narrow_phase/mesh/mesh_distance.h"

/// Signed distance of any two geometries the package knows: convex ones, meshes, sphere trees.
/// See signed_distance.h for frames and sign.
namespace collision_monitor {

/// The leaves of a sphere tree as a solid: the union of their spheres.
struct SphereUnion {
  SphereTree tree;
  /// [m] By node: radius of a sphere about its center that holds all leaves below. Leaves may stick
  /// out of the node's own sphere.
  std::vector<double> reach;
};

/// @throws std::invalid_argument when the tree has no nodes.
SphereUnion makeSphereUnion(SphereTree tree);

/// The closed set of geometries. A pair without an answer does not compile.
using GeometryRef = std::variant<const ConvexGeometry*, const MeshTree*, const SphereUnion*>;

/// Scratch, one per thread.
struct GeometrySearch {
  ConvexSearch& convex;
  MeshQueryMemory& mesh;
};

/// Measures the distance of A and B, or how deep they overlap.
///
/// Error: apart, as signedDistanceBetween of convex geometries and distanceBetween of meshes; a
/// union counts as its spheres. The depth of two convex geometries, or of a half space with a mesh
/// or a union, has the same error.
/// Limits: the depth of other solids takes more time than a cycle has. Two meshes give the length
/// of a translation that separates them, as a `lower_bound`. A mesh with a convex geometry, and
/// unions, give an `estimate`: the depth of the deepest place found.
/// @pre poses are rigid if they are finite; pointers are not null.
ConvexDistance signedDistanceBetween(const GeometryRef& a, const Pose& world_from_a,
                                     const GeometryRef& b, const Pose& world_from_b,
                                     GeometrySearch& search) noexcept;

}  // namespace collision_monitor
