// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/clock_watch.h"

namespace collision_monitor {

ClockWatch::ClockWatch(bool is_simulated, SteadyClock::time_point now)
    : is_simulated_(is_simulated),
      timeout_(std::chrono::seconds(1)),
      moved_at_(now),
      heard_at_(now),
      data_at_(now) {}

void ClockWatch::allow(double timeout) {
  const std::lock_guard<std::mutex> lock(mutex_);
  timeout_ =
      std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(timeout));
}

void ClockWatch::hear(SteadyClock::time_point now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_at_ = now;
}

ClockState ClockWatch::look(const ros::Time& time, std::uint64_t later_data,
                            SteadyClock::time_point now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  moved_at_ = time == time_ ? moved_at_ : now;
  data_at_ = later_data == later_data_ ? data_at_ : now;
  time_ = time;
  later_data_ = later_data;
  ClockState state;
  state.stood_for = std::chrono::duration<double>(now - moved_at_).count();
  // Before the clock starts there is no time at all; that is reported elsewhere.
  if (!is_simulated_ || time.isZero() || now - moved_at_ <= timeout_) {
    return state;
  }
  if (now - heard_at_ > timeout_) {
    state.fault = ClockFault::silent;
  } else if (data_at_ - moved_at_ > timeout_) {
    // Later than messages that were in transit when the clock stopped.
    state.fault = ClockFault::data_pass_it;
  }
  return state;
}

}  // namespace collision_monitor
