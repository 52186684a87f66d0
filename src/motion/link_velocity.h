// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/twist.h"

/// Velocities of links: the twist between two stamped poses, and a filter against noise.
namespace collision_monitor {

/// The constant twist that takes a body from its pose `before` to `after` in `duration`.
/// Frames: both poses in the world.
/// Limits: as screwBetween: at most half a turn.
/// @pre duration > 0 [s]
Twist twistBetween(const Pose& before, const Pose& after, double duration) noexcept;

/// The weight of a new value after `duration` [s] in a first-order low-pass. After `time_constant`
/// [s] it has followed a step to 1 - 1/e. A time constant of 0 passes everything.
double smoothingShare(double duration, double time_constant) noexcept;

/// Moves from `before` towards `now` by a share.
inline Twist smoothed(const Twist& before, const Twist& now, double share) noexcept {
  return before + share * (now - before);
}

}  // namespace collision_monitor
