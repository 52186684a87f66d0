// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "motion/approach.h"

namespace collision_monitor {

/// A body for conservative advancement.
struct MovingBall {
  const Ball& ball;
  const ScrewMotion& motion;
};

/// A measurement at one time.
struct Sighting {
  /// contact: within the contact distance; clear: farther apart, by `gap`
  SweepState state{SweepState::unknown};
  SignedDistance measured;
  double gap{0.0};        ///< [m] proven distance beyond the contact distance
  bool has_plane{false};  ///< the gap lies across a plane perpendicular to the normal
  std::uint32_t work{1};
  double outside{std::numeric_limits<double>::infinity()};  ///< [m] as MeshDistance::outside
};

inline bool isFinite(const ScrewMotion& motion) noexcept {
  return isFinite(motion.start) && motion.turn.allFinite() && motion.travel.allFinite();
}

/// How long the gap lasts: a time before which it cannot be consumed.
inline double safeTime(const MovingBall& a, const MovingBall& b, double time,
                       const Sighting& seen) noexcept {
  // The points of the smaller body stand for both, because their speeds differ least.
  const bool is_swapped = a.ball.radius < b.ball.radius;
  const Approach approach = is_swapped ? approachAt(b.motion, a.motion, a.ball, time)
                                       : approachAt(a.motion, b.motion, b.ball, time);
  const double any = timeToConsume(seen.gap, ofBall(approach, approach.center, approach.radius));
  if (!seen.has_plane) {
    return any;
  }
  const Eigen::Vector3d normal =
      is_swapped ? Eigen::Vector3d(-seen.measured.normal_a_to_b) : seen.measured.normal_a_to_b;
  return std::max(any, timeToConsume(seen.gap, acrossPlane(approach, normal)));
}

/// Surfaces are never nearer than touching.
inline double nearestOf(const SweepLimits& limits) noexcept {
  return std::max(0.0, limits.contact_distance);
}

/// Converts an approach to the frame of A.
inline Approach placedInA(const Approach& in_world, const Pose& world_from_a) noexcept {
  const Eigen::Matrix3d a_from_world = world_from_a.rotation.transpose();
  Approach in_a = in_world;
  in_a.center = a_from_world * (in_world.center - world_from_a.translation);
  in_a.velocity = a_from_world * in_world.velocity;
  in_a.turn = a_from_world * in_world.turn;
  return in_a;
}

/// How long the gap of a triangle of B lasts at least, across a plane with a normal from A to B.
inline double timeAcross(const Eigen::Vector3d& normal, double gap, const Triangle& of_b,
                         const Approach& approach) noexcept {
  // A linear field is fastest at a corner.
  double rate = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& corner : of_b) {
    rate = std::max(rate, -normal.dot(approach.velocityAt(corner)));
  }
  return timeToConsume(gap, {rate, approach.plane_growth});
}

/// Conservative advancement. `look` measures the pair at a time, within the work that is left.
/// `lasts(step, seen, found)` may tell a longer step than that which the measurement proves, and
/// adds its work.
template <class Look, class Lasts>
SweptContact advance(const MovingBall& a, const MovingBall& b, const SweepLimits& limits,
                     const Look& look, const Lasts& lasts) noexcept {
  SweptContact found;
  if (!isFinite(a.motion) || !isFinite(b.motion)) {
    return found;
  }
  found.state = SweepState::undecided;
  found.time = limits.from;
  while (found.work < limits.budget) {
    const Sighting seen = look(found.time, limits.budget - found.work);
    found.work += seen.work;
    found.measured = seen.measured;
    if (seen.state != SweepState::clear) {
      found.state = seen.state;
      return found;
    }
    const double step = safeTime(a, b, found.time, seen);
    found.time += found.time + step < limits.until ? lasts(step, seen, found) : step;
    if (!(found.time < limits.until)) {
      found.state = SweepState::clear;
      found.time = 1.0;
      return found;
    }
  }
  return found;
}

/// The same with steps that the measurements prove.
template <class Look>
SweptContact advance(const MovingBall& a, const MovingBall& b, const SweepLimits& limits,
                     const Look& look) noexcept {
  return advance(a, b, limits, look,
                 [](double step, const Sighting&, const SweptContact&) noexcept { return step; });
}

}  // namespace collision_monitor
