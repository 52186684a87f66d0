// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/twist.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// How the distance of two moving bodies changes, and when it is used up.
///
/// Frames: world. Sign: a distance that grows has a rate > 0; closing speed is minus that.
namespace collision_monitor {

/// Derivative of the signed distance by time, for bodies that are apart as well as for ones that
/// overlap: only the motion of the witness points along the normal counts, since the distance is
/// an optimum over all points and directions.
/// Units: [m/s].
/// Limits: where the nearest points jump (parallel faces, depth with two ways out) the distance
/// has a kink, and this is the rate at the points that were measured.
/// Source: Danskin's theorem; Gilbert, Johnson, "Distance functions and their application to robot
/// path planning in the presence of obstacles" (1985).
inline double distanceRate(const SignedDistance& measured, const Twist& twist_a,
                           const Twist& twist_b) noexcept {
  // Seen from A, where both points move alike along the normal.
  const Eigen::Vector3d velocity = velocityAt(twist_b - twist_a, measured.point_on_b);
  const Eigen::Vector3d& normal = measured.normal_a_to_b;
  return normal.x() * velocity.x() + normal.y() * velocity.y() + normal.z() * velocity.z();
}

/// Time until `gap` [m] is used up at `closing_speed` [m/s]: 0 if there is none left, infinity
/// if it takes longer than `horizon` [s] or nothing closes, NaN if one of both is.
///
/// For convex shapes that move without turning, the distance is a convex function of time and
/// stays above its tangent: they touch at this time or later, and never if they do not close.
double timeToContact(double gap, double closing_speed, double horizon) noexcept;

}  // namespace collision_monitor
