// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/rule_clock.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "collision_monitor/model/problems.h"

namespace collision_monitor {

RuleClock::RuleClock(std::function<RuleEnd()> next_end, std::function<void()> end_rules,
                     LogThread& log)
    : next_end_(std::move(next_end)), end_rules_(std::move(end_rules)), log_(log) {
  thread_ = std::thread([this] { run(); });
}

RuleClock::~RuleClock() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  woken_.notify_all();
  thread_.join();
}

void RuleClock::wake() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_woken_ = true;
  }
  woken_.notify_all();
}

void RuleClock::run() {
  constexpr std::chrono::seconds kAgain(1);
  constexpr std::chrono::hours kLongest(1);  // a wait until kLasts would overflow
  RuleEnd until = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_ending_) {
    woken_.wait_until(lock, until, [this] { return is_woken_ || is_ending_; });
    is_woken_ = false;
    if (is_ending_) {
      return;
    }
    lock.unlock();
    const bool is_done = endDue();
    const RuleEnd now = std::chrono::steady_clock::now();
    until = is_done ? std::min(next_end_(), now + kLongest) : now + kAgain;
    lock.lock();
  }
}

/// @return false if rules that are due could not be ended
bool RuleClock::endDue() {
  try {
    if (next_end_() <= std::chrono::steady_clock::now()) {
      end_rules_();
    }
    return true;
  } catch (const std::exception& error) {
    log_.error("rules for pairs that have ended stay in force for another second: " +
               failureText(error));
  }
  return false;
}

}  // namespace collision_monitor
