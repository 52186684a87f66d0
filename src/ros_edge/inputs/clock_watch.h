// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>

#include "ros_edge/pace.h"
#include "ros_edge/threads/inheriting_mutex.h"

namespace collision_monitor {

enum class ClockFault : unsigned char {
  none,
  not_started,   ///< no time yet
  silent,        ///< the clock sends no messages any more
  data_pass_it,  ///< the clock repeats one time, but data with later stamps arrive
};

struct ClockState {
  ClockFault fault{ClockFault::none};
  double stood_for{0.0};  ///< [s] wall time
};

/// Tells, by wall time, whether a simulated clock is alive. By a dead clock no pose ever grows old,
/// so no data can be trusted. A paused simulator repeats its time: it is alive as long as no data
/// with later stamps arrive. Safe for several threads.
class ClockWatch {
 public:
  /// @param is_simulated false: the machine's clock, which is always alive
  ClockWatch(bool is_simulated, SteadyClock::time_point now);

  /// [s] How long the clock may stand still without a message. Default: one second.
  void allow(double timeout);
  /// Notes a message of the clock, whatever time it has.
  void hear(SteadyClock::time_point now);
  /// @param time by the clock
  /// @param later_data a count that grows with data of later stamps
  ClockState look(const ros::Time& time, std::uint64_t later_data, SteadyClock::time_point now);

 private:
  const bool is_simulated_;
  mutable InheritingMutex mutex_;
  SteadyClock::duration timeout_;
  ros::Time time_;
  std::uint64_t later_data_{0};
  SteadyClock::time_point moved_at_;  ///< when the time last changed
  SteadyClock::time_point heard_at_;
  SteadyClock::time_point data_at_;  ///< when data with later stamps last arrived
};

}  // namespace collision_monitor
