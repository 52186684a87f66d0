// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// The closest point of the segment from `a` to `b`. Limits: a == b is legal.
Eigen::Vector3d closestPointOnSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                      const Eigen::Vector3d& b) noexcept;

/// The closest point of the triangle a, b, c, including its boundary.
///
/// Frames: one frame for all. Units: metres.
/// Error: the result is a point of the triangle, so its distance is never too small. It is too
/// large by at most 1e-15 of the coordinates.
/// Limits: triangles without area are legal.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.5. This departs from it: it
/// tests the three edges when the projection is not inside, and divides by no area if a triangle is
/// thin.
Eigen::Vector3d closestPointOnTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept;

}  // namespace collision_monitor
