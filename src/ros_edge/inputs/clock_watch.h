// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <mutex>

#include "ros_edge/pace.h"

namespace collision_monitor {

enum class ClockFault : unsigned char {
  none,
  not_started,   ///< no time at all yet
  silent,        ///< no message of the clock comes any more
  data_pass_it,  ///< the clock repeats one time, and data of later times come
};

struct ClockState {
  ClockFault fault{ClockFault::none};
  double stood_for{0.0};  ///< [s] of wall time
};

/// Tells on wall time whether a simulated clock lives. By a clock that is dead no pose grows old,
/// so nothing may be believed then. A simulator that is paused repeats its time: it lives, as long
/// as no data of later times come. Safe for several threads.
class ClockWatch {
 public:
  /// @param is_simulated false: the clock is that of the machine, and always lives
  ClockWatch(bool is_simulated, SteadyClock::time_point now);

  /// [s] How long the clock may stand still and say nothing. One second unless told.
  void allow(double timeout);
  /// A message of the clock came, whatever it says.
  void hear(SteadyClock::time_point now);
  /// @param time by the clock
  /// @param later_data a count that grows with data of later times
  ClockState look(const ros::Time& time, std::uint64_t later_data, SteadyClock::time_point now);

 private:
  const bool is_simulated_;
  mutable std::mutex mutex_;
  SteadyClock::duration timeout_;
  ros::Time time_;
  std::uint64_t later_data_{0};
  SteadyClock::time_point moved_at_;  ///< when the time changed
  SteadyClock::time_point heard_at_;
  SteadyClock::time_point data_at_;  ///< when data of later times came
};

}  // namespace collision_monitor
