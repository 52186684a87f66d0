// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Closest points of points, segments and boxes: the small pieces other routines are made of.
/// All arguments of a call are in one frame; units are metres.
namespace collision_monitor {

/// The points center + parameter * direction with |parameter| <= half_length.
/// `direction` is unit also when half_length is 0.
struct Segment {
  Eigen::Vector3d center;
  Eigen::Vector3d direction;
  double half_length;

  Eigen::Vector3d at(double parameter) const noexcept { return center + parameter * direction; }
};

/// A rectangle that clamps: the point of the box |x| <= half_extents nearest to `point`.
inline Eigen::Vector3d closestInBox(const Eigen::Vector3d& half_extents,
                                    const Eigen::Vector3d& point) noexcept {
  return point.cwiseMax(-half_extents).cwiseMin(half_extents);
}

/// Parameter of the segment's point nearest to `point`: before, within or after the segment.
double closestParameter(const Segment& segment, const Eigen::Vector3d& point) noexcept;

/// `outward` without what cannot belong to a normal of the segment at the point `parameter`: its
/// part along the segment, unless the point is an end and the part leads beyond it.
Eigen::Vector3d towardsNormalCone(const Segment& segment, double parameter,
                                  const Eigen::Vector3d& outward) noexcept;

/// Parameters of two nearest points.
struct ClosestParameters {
  double on_a{0.0};
  double on_b{0.0};
};

/// Nearest points of two segments.
///
/// Error: the points' distance exceeds the true one by some ulps of the lengths involved, at
/// every angle. Near parallel the points themselves are ill conditioned, their distance is not.
/// Limits: segments of zero length are points. For parallel segments that run side by side the
/// points lie in the middle of the stretch they share.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.9. Departs from it in
/// taking the first parameter from cross products: a e - b^2 loses all digits when the
/// sine nears 1e-8, and crossing segments would then be reported 1e-8 m apart.
ClosestParameters closestParameters(const Segment& a, const Segment& b) noexcept;

}  // namespace collision_monitor
