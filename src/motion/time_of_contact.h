// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "collision_monitor/geometry/half_space.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// When two shapes that do not turn first touch, by closed forms.
///
/// A stands still and B moves straight by `travel` during the interval, which runs from 0 to 1:
/// what counts is how they move against each other. Solids: shapes that overlap at the start
/// touch at 0.
/// Frames: world. Units: metres; times are shares of the interval.
/// Error: 1e-12 of the interval where they meet head-on; at a grazing touch the time is as
/// uncertain as the place.
/// Limits: shapes of size zero and no travel are legal.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.5; for boxes Gottschalk, Lin,
/// Manocha, "OBBTree" (1996) with the relative velocity on each axis: at any time two boxes are
/// apart if and only if one of fifteen axes parts them, so they touch first when the last axis
/// gives way.
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
