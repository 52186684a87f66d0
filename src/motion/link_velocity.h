// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/twist.h"

/// Velocities from poses: what two stamps tell, and a filter against their noise.
namespace collision_monitor {

/// The one twist that takes a body from its pose `before` to `after` in `duration`.
/// Frames: both poses in the world.
/// Limits: as screwBetween, by at most half a turn.
/// @pre duration > 0 [s]
Twist twistBetween(const Pose& before, const Pose& after, double duration) noexcept;

/// Of a first-order low-pass, the share of what is new after `duration` [s]: a step is followed to
/// 1 - 1/e within `time_constant` [s]; 0 passes everything.
double smoothingShare(double duration, double time_constant) noexcept;

/// From `before` to `now` by a share.
inline Twist smoothed(const Twist& before, const Twist& now, double share) noexcept {
  return before + share * (now - before);
}

}  // namespace collision_monitor
