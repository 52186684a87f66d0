// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// A rigid body that turns evenly about an axis and slides evenly along it, during an interval that
/// runs from 0 to 1. Every point of it keeps its speed.
///
/// Frames: world. Units: metres and radians, both for the whole interval.
struct ScrewMotion {
  Pose start;                                       ///< world_from_body at 0
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};    ///< along the axis, as long as the angle
  Eigen::Vector3d travel{Eigen::Vector3d::Zero()};  ///< velocity of the body's origin at 0
};

/// The screw motion from one pose to the other that turns least, by at most half a turn.
///
/// Error: reaches `end` to 1e-14 of the coordinates.
/// Limits: of half a turn, either direction. Turns below 1e-15 rad count as none.
/// Source: the logarithm of SE(3): Murray, Li, Sastry, "A Mathematical Introduction to Robotic
/// Manipulation" (1994), chapter 2; with the velocity of the body's origin in place of that of the
/// world's, so that bodies far out lose no digits.
/// @pre both poses are finite and rigid.
ScrewMotion screwBetween(const Pose& start, const Pose& end) noexcept;

/// world_from_body at a time of the interval.
Pose poseAt(const ScrewMotion& motion, double time) noexcept;

/// Velocity of a point of the body at the start. Frames: `point` in the body frame.
Eigen::Vector3d velocityAt(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept;

/// [m] How far the path of a point of the body leaves the straight line between where it is at
/// the same time if it moves straight and evenly: at most this. Frames: body.
double arcHeight(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept;

/// The motion of a body that is fixed to a link, from that of the link.
ScrewMotion carriedBy(const ScrewMotion& link_motion, const Pose& link_from_body) noexcept;

/// A box that holds the shape at every time, grown by `margin`. See aabbOf.
/// @param end poseAt(motion, 1.0), which the caller knows.
Aabb sweptAabbOf(const Shape& shape, const ScrewMotion& motion, const Pose& end,
                 double margin) noexcept;

}  // namespace collision_monitor
