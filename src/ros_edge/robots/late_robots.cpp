// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/late_robots.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>

#include "collision_monitor/model/problems.h"
#include "geometry/interruption.h"

namespace collision_monitor {

LateRobots::LateRobots(std::function<bool()> is_any_missing, std::function<void()> take_in)
    : is_any_missing_(std::move(is_any_missing)), take_in_(std::move(take_in)) {
  thread_ = std::thread([this] { run(); });
}

LateRobots::~LateRobots() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  woken_.notify_all();
  thread_.join();
}

void LateRobots::run() {
  constexpr std::chrono::milliseconds kPeriod(500);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!woken_.wait_for(lock, kPeriod, [this] { return is_ending_; })) {
    lock.unlock();
    look();
    lock.lock();
  }
}

void LateRobots::look() {
  try {
    if (is_any_missing_()) {
      take_in_();
    }
  } catch (const std::exception& error) {
    const std::string reason = failureText(error);
    if (reason != told_) {
      told_ = reason;
      ROS_ERROR_STREAM(
          "a robot that has come cannot be taken in; the others are watched as before: " << reason);
    }
  } catch (const Interrupted&) {
    // The monitor ends.
  }
}

}  // namespace collision_monitor
