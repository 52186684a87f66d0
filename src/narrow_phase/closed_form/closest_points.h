// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Closest points of points, segments and boxes: the pieces of other routines.
/// Frames: all arguments of a call are in one frame. Units: metres.
namespace collision_monitor {

/// The points center + parameter * direction with |parameter| <= half_length.
/// `direction` is a unit vector even if half_length is 0.
struct Segment {
  Eigen::Vector3d center;
  Eigen::Vector3d direction;
  double half_length;

  Eigen::Vector3d at(double parameter) const noexcept { return center + parameter * direction; }
};

/// The point of the box |x| <= half_extents that is closest to `point`.
inline Eigen::Vector3d closestInBox(const Eigen::Vector3d& half_extents,
                                    const Eigen::Vector3d& point) noexcept {
  return point.cwiseMax(-half_extents).cwiseMin(half_extents);
}

/// Parameter of the segment's point that is closest to `point`.
double closestParameter(const Segment& segment, const Eigen::Vector3d& point) noexcept;

/// Makes `outward` a possible normal of the segment at the point `parameter`: removes its part
/// along the segment, unless the point is an end and the part leads beyond it.
Eigen::Vector3d towardsNormalCone(const Segment& segment, double parameter,
                                  const Eigen::Vector3d& outward) noexcept;

/// Parameters of two closest points.
struct ClosestParameters {
  double on_a{0.0};
  double on_b{0.0};
};

/// Finds the closest points of two segments.
///
/// Error: the points' distance exceeds the true one by a few ulps of the lengths, at every angle.
/// Near parallel the points are ill conditioned, but their distance is not.
/// Limits: a segment of zero length is a point. For parallel segments side by side the points lie
/// in the middle of their common part.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.9. Departure: the first
/// parameter comes from cross products, because a e - b^2 loses all digits at sines near 1e-8 and
/// would report crossing segments 1e-8 m apart.
ClosestParameters closestParameters(const Segment& a, const Segment& b) noexcept;

}  // namespace collision_monitor
