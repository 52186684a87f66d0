// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "motion/screw_motion.h"

namespace collision_monitor {

/// A sphere whose center goes straight by `travel` during the interval, which runs from 0 to 1.
/// Frames: world. Units: metres.
struct MovingSphere {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< at the start
  Eigen::Vector3d travel{Eigen::Vector3d::Zero()};
  double reach{0.0};   ///< radius
  double length{0.0};  ///< of the travel
};

/// Holds, at every time, the sphere of radius `radius` about `center` (body frame) that the motion
/// carries: its radius is larger by as much as the center's arc leaves the straight line, and by a
/// rounding allowance.
///
/// Source: a path leaves its chord by at most an eighth of its greatest acceleration (the error of
/// linear interpolation); a point on a screw motion accelerates evenly.
MovingSphere movingSphereOf(const ScrewMotion& motion, const Eigen::Vector3d& center,
                            double radius) noexcept;

/// Two tests that may say true too often and never false too often, each sharper and dearer than
/// the one before. Both grow the sum of the radii: the first by the lengths of both travels and
/// without a root, the second by what of the relative travel closes along the line of centers.
/// @param margin [m] spheres this near count as meeting.
bool mayMeetBySpeed(const MovingSphere& a, const MovingSphere& b, double margin) noexcept;
bool mayMeetByClosing(const MovingSphere& a, const MovingSphere& b, double margin) noexcept;

}  // namespace collision_monitor
