// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// A lower bound, valid in exact arithmetic, of the distance between the segment from `a` to `b`
/// and a triangle, an upper limit apart: once it is known to be `enough` or more, any bound from
/// there on is returned.
///
/// For a unit vector n the distance is at least min over the segment of n . p less the largest
/// n . corner, whatever n is. Two such bounds, with n from the nearest points of two places of the
/// segment, are lines over the segment; the distance is convex along it, so their crossing tells
/// where to look next, and converges like a cutting-plane method. The bound is lessened by
/// 64 u of the largest coordinate for rounding.
/// Error: below the distance by about 1e-12 of the lengths. 0 when they cross or touch.
/// Source: Kelley, "The Cutting-Plane Method for Solving Convex Programs" (1960).
double clearanceBound(const TriangleBvh::Triangle& triangle, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b, double cutoff) noexcept;

/// The same over all triangles of a mesh. Limits: a == b is legal.
double clearanceBound(const TriangleBvh& mesh, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b) noexcept;

}  // namespace collision_monitor
