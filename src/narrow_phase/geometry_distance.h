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
  /// [m] By node: radius about its center that holds all leaves below it, whose spheres may stick
  /// out of the node's own.
  std::vector<double> reach;
};

/// @throws std::invalid_argument when the tree has no nodes.
SphereUnion makeSphereUnion(SphereTree tree);

/// The closed set: every pair of them has an answer, or does not compile.
using GeometryRef = std::variant<const ConvexGeometry*, const MeshTree*, const SphereUnion*>;

/// Scratch; one a thread.
struct GeometrySearch {
  ConvexSearch& convex;
  MeshQueryMemory& mesh;
};

/// The least distance of A and B, or how deep they overlap.
///
/// Error: apart, as signedDistanceBetween of convex geometries and distanceBetween of meshes; the
/// unions of spheres with what they are measured against. Depth of convex geometries likewise, and
/// of a mesh or a union and a half space.
/// Limits: nobody knows the depth of solids that are not convex in a cycle. Two meshes give the
/// length of a translation that separates them, as a `lower_bound`; a mesh and a convex geometry,
/// and unions, an `estimate`: the depth of the deepest place found.
/// @pre poses are rigid if they are finite; pointers are not null.
ConvexDistance signedDistanceBetween(const GeometryRef& a, const Pose& world_from_a,
                                     const GeometryRef& b, const Pose& world_from_b,
                                     GeometrySearch& search) noexcept;

}  // namespace collision_monitor
