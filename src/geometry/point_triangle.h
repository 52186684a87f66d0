// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The nearest point of the segment from `a` to `b`. Limits: a == b is legal.
Eigen::Vector3d closestPointOnSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                      const Eigen::Vector3d& b) noexcept;

/// The nearest point of the triangle a, b, c, its boundary and inside included.
///
/// Frames: one frame for all. Units: metres.
/// Error: the result is a point of the triangle, so its distance is never too small; it is too
/// large by at most 1e-15 of the coordinates.
/// Limits: triangles without area are legal.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.5; departs from it in
/// falling back to the three edges when the foot of the perpendicular is not inside, and in
/// dividing by no area where a triangle is thin.
Eigen::Vector3d closestPointOnTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept;

}  // namespace collision_monitor
