// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// How a robot is to be slowed down before its links meet. The scale multiplies its speed, as
/// MoveIt Servo's collision velocity scale does: 1 full speed, 0 stop.
struct StopRule {
  double stop_distance{0.01};  ///< [m] a pair that closes at this distance or nearer: 0
  double stop_time{0.25};      ///< [s] > 0; a pair may close as fast as to get there in this time
  double release_time{0.5};    ///< [s] > 0; in which the scale may grow from 0 to 1
  double rest_speed{0.002};    ///< [m/s] >= 0; slower than this, a pair neither closes nor parts
  double creep_scale{0.0};     ///< of a pair that was stopped, while it rests
};

/// What one pair asks for. A pair that does not close asks for nothing (1); one that closes, for
/// the speed at which it would reach stop_distance in stop_time.
/// @pre closing_speed [m/s] is a number
double scaleForPair(double distance, double closing_speed, const StopRule& rule) noexcept;

/// What a pair asks for while nobody knows how it moves: as if it closed, by its distance alone,
/// from 1 at `slow_distance` [m] to 0 at stop_distance.
double scaleForUnknownSpeed(double distance, double slow_distance, const StopRule& rule) noexcept;

/// The scale that follows `before` after `duration` [s] while `wanted` is asked for. Falls at
/// once and grows slowly: what was slowed down closes more slowly and asks for less, and the two
/// would chase each other.
double releasedScale(double before, double wanted, double duration, const StopRule& rule) noexcept;

}  // namespace collision_monitor
