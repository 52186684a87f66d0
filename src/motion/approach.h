// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "motion/conservative_advancement.h"

/// Bounds of how fast two bodies on screw motions can approach, for conservative advancement.
///
/// Seen from A, a material point x of B moves with the velocity field
/// w(x) = velocity + turn x (x - center). In the world, screw motions keep this field constant
/// during the interval. Let a plane be fixed to A, with normal n from A to B. A point q of B
/// approaches it at the speed -n . w(q). Over time n turns with A and q moves, so this speed
/// changes no faster than
///   |turn of A| * |w(q)| + |turn| * |speed of q|.
/// The distance of any two sets changes no faster than the greatest |w(q)|.
namespace collision_monitor {

/// An upper bound of how fast a gap is consumed: `rate` + `growth` * t after the time t. [m] per
/// interval.
struct Consumption {
  double rate{0.0};
  double growth{0.0};

  double within(double time) const noexcept { return time * (rate + 0.5 * growth * time); }
};

/// How long a gap lasts at least: the time after which it may be consumed; infinite if never.
/// @pre gap > 0.
double timeToConsume(double gap, const Consumption& consumption) noexcept;

/// The velocity field at one time, and bounds of it until the end of the interval.
struct Approach {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< of B's ball
  Eigen::Vector3d velocity{Eigen::Vector3d::Zero()};
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};
  double radius{0.0};  ///< of B's ball
  double turn_length{0.0};
  double point_speed{0.0};   ///< bounds the speed of B's points in the world
  double plane_growth{0.0};  ///< growth of consumption across a plane fixed to A

  Eigen::Vector3d velocityAt(const Eigen::Vector3d& point) const noexcept {
    return velocity + turn.cross(point - center);
  }
};

/// @param time at which the velocities are taken.
Approach approachAt(const ScrewMotion& motion_a, const ScrewMotion& motion_b, const Ball& ball_b,
                    double time) noexcept;

/// Consumption of the gap between convex sets across a plane with unit normal from A to B.
Consumption acrossPlane(const Approach& approach, const Eigen::Vector3d& normal) noexcept;

/// Consumption of the distance of any sets, B's in the given ball (frame of `approach`).
Consumption ofBall(const Approach& approach, const Eigen::Vector3d& center, double radius) noexcept;

}  // namespace collision_monitor
