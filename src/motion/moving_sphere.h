// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "motion/screw_motion.h"

namespace collision_monitor {

/// A sphere whose center moves straight by `travel` during the interval from 0 to 1.
/// Frames: world. Units: metres.
struct MovingSphere {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< at the start
  Eigen::Vector3d travel{Eigen::Vector3d::Zero()};
  double reach{0.0};   ///< radius
  double length{0.0};  ///< of the travel
};

/// Holds, at every time, the moving sphere of radius `radius` about `center` (body frame). Its
/// radius is greater by the center's greatest deviation from the straight line, and by a rounding
/// allowance.
///
/// Source: a path leaves its chord by at most an eighth of its greatest acceleration (the error of
/// linear interpolation). The acceleration of a point on a screw motion has constant magnitude.
MovingSphere movingSphereOf(const ScrewMotion& motion, const Eigen::Vector3d& center,
                            double radius) noexcept;

/// Two conservative tests: they may return true too often, never false too often. The second is
/// sharper and costlier. Both inflate the sum of radii: the first by the lengths of both travels,
/// without a root; the second by the relative travel along the line of centers.
/// @param margin [m] spheres this near count as meeting.
bool mayMeetBySpeed(const MovingSphere& a, const MovingSphere& b, double margin) noexcept;
bool mayMeetByClosing(const MovingSphere& a, const MovingSphere& b, double margin) noexcept;

}  // namespace collision_monitor
