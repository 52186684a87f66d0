// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/geometry/triangle_mesh.h"

/// Slow exact distances of triangles, cores and meshes, by another road than the package's and in
/// extended precision (64-bit mantissa).
///
/// Every convex polyhedron is the list of its features, each a flat patch with free parameters.
/// Two nearest points lie inside one feature each, where they are the least squares solution for
/// the two planes, lines or points that the features span. So: solve for every pair of features
/// with at most three parameters between them, and keep the nearest solution inside both.
namespace collision_monitor::test {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;

/// Points base + sum of parameter * direction. Parameters are 0..1 each; of a corner (a simplex)
/// their sum is at most 1.
struct ReferenceFeature {
  RealVector base;
  std::vector<RealVector> directions;
  bool is_simplex{false};
};

using ReferencePolytope = std::vector<ReferenceFeature>;

ReferencePolytope polytopeOf(const Triangle& triangle);
/// The core of a shape, in the world.
ReferencePolytope polytopeOf(const Shape& shape, const Pose& world_from_shape);

/// 0 when they share a point. Takes tens of microseconds.
Real referenceDistance(const ReferencePolytope& a, const ReferencePolytope& b);

/// The least over all pairs of triangles, and over all triangles.
Real referenceDistance(const TriangleMesh& a, const Pose& world_from_a, const TriangleMesh& b,
                       const Pose& world_from_b);
Real referenceCoreDistance(const TriangleMesh& a, const Pose& world_from_a, const Shape& b,
                           const Pose& world_from_b);

}  // namespace collision_monitor::test
