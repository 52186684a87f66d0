// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

enum class RealTimeState : unsigned char {
  off,       ///< not asked for
  on,        ///< only threads of higher priority delay this one
  refused,   ///< the system does not permit it
  given_up,  ///< too many cycles in a row were late
};

/// Sets the priority of the calling thread, on Linux by SCHED_FIFO. Threads that it starts do not
/// inherit it.
/// @param priority 1 to 99; 0: none
/// @return false if the system does not permit it; then nothing has changed
bool setRealTimePriority(int priority) noexcept;

/// The real-time priority of one thread. All calls come from this thread.
class RealTime {
 public:
  /// Asks again if the last answer was no or the priority was given up, unless the last cycle was
  /// late. @param priority 1 to 99; 0: none
  void set(int priority) noexcept;
  /// Counts a cycle. Too many late ones in a row end the priority: they would leave no time to
  /// other threads. Many in time bring it back.
  void add(bool is_late) noexcept;
  RealTimeState state() const noexcept { return state_; }
  /// 0 unless it is on.
  int priority() const noexcept { return state_ == RealTimeState::on ? priority_ : 0; }

 private:
  void end(RealTimeState state) noexcept;

  RealTimeState state_{RealTimeState::off};
  int priority_{0};
  int late_in_a_row_{0};
  int in_time_in_a_row_{0};
};

}  // namespace collision_monitor
