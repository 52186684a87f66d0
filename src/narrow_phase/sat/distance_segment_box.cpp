// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/sat/axis_contact.h"

// Apart: the squared distance to the box is convex along the segment, and quadratic between the
// parameters where the segment crosses a face plane. The slope at these (at most six) parameters
// brackets the minimum where the slope is linear. One search covers corners, edges and faces, and
// parallel ones need no case of their own. Overlapping: separating axes.
namespace collision_monitor {
namespace {

// Frames: the box's.
struct SegmentAndBox {
  Segment segment;
  Eigen::Vector3d half_extents;
  double rounding;  // a coordinate that little outside of a slab counts as inside
};

// Half the derivative of the squared distance to the box at segment.at(parameter).
double slopeAt(const SegmentAndBox& pair, double parameter) noexcept {
  double slope = 0.0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double x = pair.segment.center[k] + parameter * pair.segment.direction[k];
    const double beyond = std::abs(x) - pair.half_extents[k];
    slope += beyond > pair.rounding ? std::copysign(beyond, x) * pair.segment.direction[k] : 0.0;
  }
  return slope;
}

// Where the slope changes sign: negative at low, positive at high, zero from flat_low to
// flat_high if that is not empty.
struct Bracket {
  double low, slope_low, high, slope_high;
  double flat_low, flat_high;

  void narrow(double parameter, double slope) noexcept {
    if (slope < 0.0) {
      low = parameter;
      slope_low = slope;
    } else if (slope > 0.0) {
      high = parameter;
      slope_high = slope;
    } else {
      flat_low = std::min(flat_low, parameter);
      flat_high = std::max(flat_high, parameter);
    }
  }
};

double nearestParameter(const SegmentAndBox& pair) noexcept {
  const double end = pair.segment.half_length;
  const double slope_first = slopeAt(pair, -end);
  const double slope_last = slopeAt(pair, end);
  if (slope_first > 0.0) {
    return -end;
  }
  if (slope_last < 0.0) {
    return end;
  }
  Bracket bracket{-end, slope_first, end, slope_last, end, -end};
  bracket.narrow(-end, slope_first);
  bracket.narrow(end, slope_last);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double direction = pair.segment.direction[k];
    for (const double face : {-pair.half_extents[k], pair.half_extents[k]}) {
      // A constant coordinate crosses no plane: the quotient is then infinite or NaN.
      const double parameter = (face - pair.segment.center[k]) / direction;
      if (parameter > bracket.low && parameter < bracket.high) {
        bracket.narrow(parameter, slopeAt(pair, parameter));
      }
    }
  }
  if (bracket.flat_low <= bracket.flat_high) {
    return 0.5 * (bracket.flat_low + bracket.flat_high);
  }
  const double share = bracket.slope_low / (bracket.slope_low - bracket.slope_high);
  return bracket.low + share * (bracket.high - bracket.low);
}

// The box is A.
SignedDistance boxToSegment(const BoxPair& pair) noexcept {
  // Directions that are parallel to a face up to rounding become exactly so. This finds the middle
  // of the part beside the face.
  Eigen::Vector3d direction = pair.a_from_b.col(2);
  direction = (direction.array().abs() > kParallel).select(direction, 0.0);
  const SegmentAndBox here{
      {pair.center_of_b, direction, pair.half_b.z()}, pair.half_a, toleranceOf(pair)};
  const double parameter = nearestParameter(here);
  SignedDistance cores;
  cores.point_on_b = here.segment.at(parameter);
  cores.point_on_a = closestInBox(here.half_extents, cores.point_on_b);
  const Eigen::Vector3d between = cores.point_on_b - cores.point_on_a;
  cores.distance = between.norm();
  if (cores.distance > kNear) {
    cores.normal_a_to_b = between / cores.distance;
    return cores;
  }
  // Overlapping, or so near that the features give a better normal than the difference.
  const Separations separations = separationsOfBoxAndSegment(pair);
  SignedDistance along_axis;
  if (cores.distance <= kTouching) {
    return nearestContact(pair, separations);
  }
  if (contactAlongAxis(pair, separations, along_axis)) {
    return along_axis;
  }
  cores.normal_a_to_b = -towardsNormalCone(here.segment, parameter, -between).normalized();
  return cores;
}

}  // namespace

SignedDistance distanceBetween(const Capsule& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept {
  const Eigen::Vector3d half_segment(0.0, 0.0, a.half_length);
  const BoxPair pair = makeBoxPair(b.half_extents, world_from_b, half_segment, world_from_a);
  const SignedDistance cores = swapped(placed(world_from_b, boxToSegment(pair)));
  return inflated(cores, a.radius, b.radius);
}

}  // namespace collision_monitor
