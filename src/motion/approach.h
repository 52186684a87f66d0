// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "motion/conservative_advancement.h"

/// How fast two bodies on screw motions can come nearer: the bounds behind conservative
/// advancement.
///
/// Seen from A, the material points x of B move with the velocity field
/// w(x) = velocity + turn x (x - center), which screw motions keep the same in the world for the
/// whole interval. A plane fixed to A with normal n, from A to B, is approached by a point q of B
/// at -n . w(q). While time goes on, n turns with A and q moves, so that this changes no faster
/// than
///   |turn of A| * |w(q)| + |turn| * |speed of q|.
/// The distance of any two sets changes no faster than the greatest |w(q)|.
namespace collision_monitor {

/// Nothing is consumed faster than `rate` + `growth` * t, t the time that has passed. [m], per
/// interval.
struct Consumption {
  double rate{0.0};
  double growth{0.0};

  double within(double time) const noexcept { return time * (rate + 0.5 * growth * time); }
};

/// How long a gap lasts: the time after which it may be consumed; infinite if never.
/// @pre gap > 0.
double timeToConsume(double gap, const Consumption& consumption) noexcept;

/// The velocity field at one time, and bounds of what follows until the end of the interval.
struct Approach {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< of B's ball
  Eigen::Vector3d velocity{Eigen::Vector3d::Zero()};
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};
  double radius{0.0};  ///< of B's ball
  double turn_length{0.0};
  double point_speed{0.0};   ///< bounds the speed of B's points in the world
  double plane_growth{0.0};  ///< of consumption across a plane fixed to A

  Eigen::Vector3d velocityAt(const Eigen::Vector3d& point) const noexcept {
    return velocity + turn.cross(point - center);
  }
};

/// @param time at which the bodies are looked at.
Approach approachAt(const ScrewMotion& motion_a, const ScrewMotion& motion_b, const Ball& ball_b,
                    double time) noexcept;

/// Of the gap between convex sets, across a plane with this unit normal, from A to B.
Consumption acrossPlane(const Approach& approach, const Eigen::Vector3d& normal) noexcept;

/// Of the distance between any sets, of which that of B is in a ball (frame of `approach`).
Consumption ofBall(const Approach& approach, const Eigen::Vector3d& center, double radius) noexcept;

}  // namespace collision_monitor
