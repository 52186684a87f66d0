// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/threads/log_thread.h"

namespace collision_monitor {

/// Calls a function on its own thread when the next rule ends. By steady time: a clock that jumps
/// must not keep a pair muted.
class RuleClock {
 public:
  /// @param next_end when to call `end_rules`; asked after each call and each `wake`
  /// @param end_rules may throw: it is then called again a second later
  /// @pre the log outlives the clock
  RuleClock(std::function<RuleEnd()> next_end, std::function<void()> end_rules, LogThread& log);
  ~RuleClock();
  RuleClock(const RuleClock&) = delete;
  RuleClock& operator=(const RuleClock&) = delete;

  /// After the rules have changed.
  void wake();

 private:
  void run();
  bool endDue();

  std::function<RuleEnd()> next_end_;
  std::function<void()> end_rules_;
  LogThread& log_;
  std::mutex mutex_;  ///< guards the next three
  std::condition_variable woken_;
  bool is_woken_{false};
  bool is_ending_{false};
  std::thread thread_;
};

}  // namespace collision_monitor
