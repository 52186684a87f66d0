// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

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

/// Conservative advancement. `look` measures the pair at a time, within the work that is left.
template <class Look>
SweptContact advance(const MovingBall& a, const MovingBall& b, const SweepLimits& limits,
                     const Look& look) noexcept {
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
    found.time += safeTime(a, b, found.time, seen);
    if (!(found.time < limits.until)) {
      found.state = SweepState::clear;
      found.time = 1.0;
      return found;
    }
  }
  return found;
}

}  // namespace collision_monitor
