// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/real_time.h"

#include <sched.h>

#include <algorithm>

namespace collision_monitor {

bool setRealTimePriority(int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  // Of the calling thread. Others that it starts are normal.
  const int policy = (priority > 0 ? SCHED_FIFO : SCHED_OTHER) | SCHED_RESET_ON_FORK;
  return sched_setscheduler(0, policy, &parameters) == 0;
}

void RealTime::set(int priority) noexcept {
  const bool is_same = priority == priority_;
  if (is_same && (state_ == RealTimeState::on || late_in_a_row_ > 0)) {
    return;
  }
  priority_ = priority;
  end(priority > 0 ? RealTimeState::refused : RealTimeState::off);
  if (priority > 0 && setRealTimePriority(priority)) {
    state_ = RealTimeState::on;
  }
}

void RealTime::add(bool is_late) noexcept {
  constexpr int kTooMany = 100;
  constexpr int kEnough = 1000;
  late_in_a_row_ = is_late ? std::min(late_in_a_row_ + 1, kTooMany) : 0;
  in_time_in_a_row_ = is_late ? 0 : std::min(in_time_in_a_row_ + 1, kEnough);
  if (late_in_a_row_ == kTooMany && state_ == RealTimeState::on) {
    end(RealTimeState::given_up);
  }
  if (in_time_in_a_row_ == kEnough && state_ == RealTimeState::given_up) {
    set(priority_);
  }
}

void RealTime::end(RealTimeState state) noexcept {
  if (state_ == RealTimeState::on) {
    setRealTimePriority(0);
  }
  state_ = state;
}

}  // namespace collision_monitor
