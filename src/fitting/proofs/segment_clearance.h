// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// A lower bound, valid in exact arithmetic, of the distance between the segment from `a` to `b`
/// and a triangle. Once a bound of at least `cutoff` is found, it is returned.
///
/// For any unit vector n, the distance is at least the minimum of n . p over the segment minus the
/// largest n . corner. Take n from the closest points at two places of the segment: both bounds are
/// lines over the segment. The distance is convex along it, so the crossing of the lines is the
/// next place to test. This converges like a cutting-plane method. The bound is lowered by 64 u of
/// the largest coordinate for rounding.
/// Error: below the distance by about 1e-12 of the lengths. 0 when they cross or touch.
/// Source: Kelley, "The Cutting-Plane Method for Solving Convex Programs" (1960).
double clearanceBound(const TriangleBvh::Triangle& triangle, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b, double cutoff) noexcept;

/// As above, over all triangles of a mesh. Limits: a == b is legal.
double clearanceBound(const TriangleBvh& mesh, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b) noexcept;

}  // namespace collision_monitor
