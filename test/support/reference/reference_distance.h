// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor::test {

/// The result of the slow exact reference for a pair.
///
/// Sign and normal as in SignedDistance. If the normal is not unique, it is one of several.
struct Reference {
  double distance{0.0};
  Eigen::Vector3d normal_a_to_b{Eigen::Vector3d::UnitX()};
  /// For cores apart: the distance of two actual points, minus the largest gap of the cores'
  /// projections on a line, which no two points can undercut. The true distance lies between, so
  /// this bounds the reference's error. 0 for overlaps.
  double certified_gap{0.0};
};

/// Signed distance by another method than the package's, in extended precision (64-bit mantissa).
///
/// The Minkowski difference of two cores is a zonotope: center + sum of lambda_k g_k with
/// |lambda_k| <= 1 and up to six generators g_k, the half edges of both. Apart: its point nearest
/// to the origin is a least squares problem with bounds, solved for every choice of at most two
/// free variables, with the rest at their bounds. Overlapping: the depth is the least distance to a
/// supporting plane over all possible facet normals. These are the cross products of the generators
/// and, for flat zonotopes, the axes of both poses.
///
/// Error: about 1e-18 relative to the lengths involved. Takes tens of microseconds.
/// Source: McMullen, "On zonotopes" (1971), for facets and their tilings.
Reference referenceDistance(const Shape& a, const Pose& world_from_a, const Shape& b,
                            const Pose& world_from_b);

}  // namespace collision_monitor::test
