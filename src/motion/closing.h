// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/twist.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// How fast the distance of two moving bodies changes, and when it is used up.
///
/// Frames: world. Sign: the rate is > 0 when the distance grows; the closing speed is its negative.
namespace collision_monitor {

/// Time derivative of the signed distance, for bodies that are apart or overlap. Only the motion of
/// the witness points along the normal counts, because the distance is an optimum over all points
/// and directions.
/// Units: [m/s].
/// Limits: where witness points jump (parallel faces, two directions of equal penetration depth),
/// the distance has a kink. The rate then belongs to the points that were measured.
/// Source: Danskin's theorem; Gilbert, Johnson, "Distance functions and their application to robot
/// path planning in the presence of obstacles" (1985).
inline double distanceRate(const SignedDistance& measured, const Twist& twist_a,
                           const Twist& twist_b) noexcept {
  // Relative to A. Along the normal both points move alike.
  const Eigen::Vector3d velocity = velocityAt(twist_b - twist_a, measured.point_on_b);
  const Eigen::Vector3d& normal = measured.normal_a_to_b;
  return normal.x() * velocity.x() + normal.y() * velocity.y() + normal.z() * velocity.z();
}

/// Time until `gap` [m] is used up at `closing_speed` [m/s]. 0 if no gap is left, infinity if it
/// takes longer than `horizon` [s] or nothing closes, NaN if the gap or the speed is NaN.
///
/// For convex shapes that move without turning, the distance is a convex function of time and stays
/// above its tangent. So they touch at this time or later, and never if they do not close.
double timeToContact(double gap, double closing_speed, double horizon) noexcept;

}  // namespace collision_monitor
