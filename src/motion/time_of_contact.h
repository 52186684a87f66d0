// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "collision_monitor/geometry/half_space.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// When two shapes that do not rotate first touch, in closed form.
///
/// A stands still and B moves straight by `travel` during the interval from 0 to 1: only their
/// relative motion counts. Shapes are solid: if they overlap at the start, they touch at 0.
/// Frames: world. Units: metres; times are fractions of the interval.
/// Error: 1e-12 of the interval for head-on contact. At grazing contact the time is as uncertain as
/// the place.
/// Limits: shapes of size zero and zero travel are legal.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.5. Boxes: Gottschalk, Lin,
/// Manocha, "OBBTree" (1996), with the relative velocity on each axis. Two boxes are apart if and
/// only if one of fifteen separating axes exists, so they first touch when the last one vanishes.
/// @pre poses and travel are finite, poses rigid.
/// @return nothing if they do not touch within the interval.

std::optional<double> timeOfContact(const Sphere& a, const Pose& world_from_a, const Sphere& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept;
std::optional<double> timeOfContact(const HalfSpace& a, const Pose& world_from_a, const Sphere& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept;
std::optional<double> timeOfContact(const HalfSpace& a, const Pose& world_from_a, const Box& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept;
std::optional<double> timeOfContact(const Box& a, const Pose& world_from_a, const Box& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept;

}  // namespace collision_monitor
