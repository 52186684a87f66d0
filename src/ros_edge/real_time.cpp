// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/real_time.h"

#include <pthread.h>
#include <sched.h>

namespace collision_monitor {
namespace {

/// @return false if the system does not permit it; then nothing has changed.
bool setPolicy(int policy, int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), policy, &parameters) == 0;
}

}  // namespace

void RealTime::set(int priority) noexcept {
  late_in_a_row_ = 0;
  const bool is_wanted = priority > 0;
  if (is_wanted && !(state_ == RealTimeState::on && priority == priority_)) {
    state_ = setPolicy(SCHED_FIFO, priority) ? RealTimeState::on : RealTimeState::refused;
  } else if (!is_wanted && state_ == RealTimeState::on) {
    setPolicy(SCHED_OTHER, 0);
  }
  state_ = is_wanted ? state_ : RealTimeState::off;
  priority_ = priority;
}

void RealTime::add(bool is_late) noexcept {
  constexpr int kTooMany = 100;
  late_in_a_row_ = is_late ? late_in_a_row_ + 1 : 0;
  if (late_in_a_row_ >= kTooMany && state_ == RealTimeState::on) {
    setPolicy(SCHED_OTHER, 0);
    state_ = RealTimeState::given_up;
  }
}

}  // namespace collision_monitor
