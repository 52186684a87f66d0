// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/geometry/winding.h"
#include "support/random_poses.h"

/// Meshes that break mesh queries where simpler ones would not.
namespace collision_monitor::test {

/// A closed body with hills and hollows, `length` [m] long along x and 0.7 of that across.
TriangleMesh bumpyMesh(double length, int sectors);

/// `count` unordered triangles, with needles, segments and points among them.
TriangleMesh triangleSoup(double reach, int count, Random& random);

/// The tree of a surface that need not be closed, as set-ups build it.
inline MeshTree openTree(const TriangleMesh& mesh) {
  return MeshTree::ofOriented(orientedSurface(mesh));
}

}  // namespace collision_monitor::test
