// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/geometry/triangle_mesh.h"

/// Slow exact distances of triangles, cores and meshes, by another method than the package's and in
/// extended precision (64-bit mantissa).
///
/// A convex polyhedron is a list of its features, each a flat patch with free parameters. Two
/// closest points lie inside one feature each. They are the least squares solution for the planes,
/// lines or points that these features span. So this solves for every pair of features with at most
/// three parameters in total, and keeps the nearest solution inside both.
namespace collision_monitor::test {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;

/// Points base + sum of parameter * direction. Each parameter is in 0..1; for a simplex their sum
/// is at most 1.
struct ReferenceFeature {
  RealVector base;
  std::vector<RealVector> directions;
  bool is_simplex{false};
};

using ReferencePolytope = std::vector<ReferenceFeature>;

ReferencePolytope polytopeOf(const Triangle& triangle);
/// The core of a shape, in the world.
ReferencePolytope polytopeOf(const Shape& shape, const Pose& world_from_shape);

/// 0 if they share a point. Takes tens of microseconds.
Real referenceDistance(const ReferencePolytope& a, const ReferencePolytope& b);

/// The least distance over all pairs of triangles, or over all triangles.
Real referenceDistance(const TriangleMesh& a, const Pose& world_from_a, const TriangleMesh& b,
                       const Pose& world_from_b);
Real referenceCoreDistance(const TriangleMesh& a, const Pose& world_from_a, const Shape& b,
                           const Pose& world_from_b);

}  // namespace collision_monitor::test
