// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// A rigid body that turns and slides at constant rates about and along an axis, during an interval
/// from 0 to 1. Every point of it has constant speed.
///
/// Frames: world. Units: metres and radians, both per interval.
struct ScrewMotion {
  Pose start;                                       ///< world_from_body at 0
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};    ///< along the axis; its length is the angle
  Eigen::Vector3d travel{Eigen::Vector3d::Zero()};  ///< velocity of the body's origin at 0
};

/// The screw motion between two poses with the smallest rotation, at most half a turn.
///
/// Error: reaches `end` to 1e-14 of the coordinates.
/// Limits: a half turn takes either direction. Turns below 1e-15 rad count as none.
/// Source: the logarithm of SE(3): Murray, Li, Sastry, "A Mathematical Introduction to Robotic
/// Manipulation" (1994), chapter 2. It uses the velocity of the body's origin, not of the world's,
/// so bodies far from the origin lose no digits.
/// @pre both poses are finite and rigid.
ScrewMotion screwBetween(const Pose& start, const Pose& end) noexcept;

/// world_from_body at a time of the interval.
Pose poseAt(const ScrewMotion& motion, double time) noexcept;

/// Velocity of a point of the body at the start. Frames: `point` in the body frame.
Eigen::Vector3d velocityAt(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept;

/// [m] An upper bound of the distance between a body's point and a point that moves evenly along
/// its chord, at the same time. Frames: body.
double arcHeight(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept;

/// The motion of a body that is fixed to a link, from the motion of the link.
ScrewMotion carriedBy(const ScrewMotion& link_motion, const Pose& link_from_body) noexcept;

/// A box that holds the shape at every time of the motion, inflated by `margin`. See aabbOf.
/// @param end poseAt(motion, 1.0), which the caller has at hand.
Aabb sweptAabbOf(const Shape& shape, const ScrewMotion& motion, const Pose& end,
                 double margin) noexcept;

}  // namespace collision_monitor
