// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/log_thread.h"

#include <ros/console.h>

#include <utility>

namespace collision_monitor {

LogThread::LogThread() : thread_([this] { write(); }) {}

void LogThread::add(Line line) {
  constexpr std::size_t kMostWaiting = 20000;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.size() < kMostWaiting) {
      waiting_.push_back(std::move(line));
    } else {
      ++left_out_;
    }
  }
  thread_.wake();
}

void LogThread::log(const Line& line) {
  switch (line.level) {
    case Level::info:
      ROS_INFO_STREAM(line.text);
      break;
    case Level::warning:
      ROS_WARN_STREAM(line.text);
      break;
    case Level::error:
      ROS_ERROR_STREAM(line.text);
      break;
  }
}

void LogThread::write() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!waiting_.empty()) {
    const Line line = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    log(line);
    lock.lock();
  }
  const std::uint64_t left_out = std::exchange(left_out_, 0);
  lock.unlock();
  if (left_out > 0) {
    ROS_WARN_STREAM("too much to log at once; lines left out: " << left_out);
  }
}

}  // namespace collision_monitor
