// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_mesh.h"

/// Meshes with known answers, for tests of fitting and of mesh distances.
namespace collision_monitor::test {

/// Corners at +-half, twelve outward triangles.
TriangleMesh boxMesh(const Eigen::Vector3d& half_extents);

/// As above, about another center.
TriangleMesh boxMeshAt(const Eigen::Vector3d& half_extents, const Eigen::Vector3d& center);

/// As boxMesh, without its top.
TriangleMesh openBoxMesh(const Eigen::Vector3d& half_extents);

/// A closed tube around z. Each rim has `sides` corners, which lie on the circle.
TriangleMesh prismMesh(double radius, double half_length, int sides);

/// A closed sphere of rings and sectors, with all vertices on the sphere, poles included.
TriangleMesh sphereMesh(double radius, int sectors);

/// Random points in a box, as arbitrary triangles: only their hull counts.
TriangleMesh randomCloud(const Eigen::Vector3d& half_extents, int count, unsigned seed);

/// The mesh rotated by a rotation vector and shifted.
TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& turn,
                   const Eigen::Vector3d& shift);
TriangleMesh scaled(const TriangleMesh& mesh, double factor);
/// Both as one mesh.
TriangleMesh joined(TriangleMesh a, const TriangleMesh& b);

}  // namespace collision_monitor::test
