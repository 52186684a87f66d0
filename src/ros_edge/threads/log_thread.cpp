// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/log_thread.h"

#include <poll.h>
#include <ros/console.h>
#include <unistd.h>

#include <utility>

namespace collision_monitor {

LogThread::LogThread() : thread_([this] { write(); }) {}

LogThread::~LogThread() { is_ending_ = true; }

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

/// rosconsole holds a lock while it writes, which the end of ROS needs: so this waits before.
/// @return false if the log ends and the console stands still
bool LogThread::waitForConsole() const {
  constexpr int kPause = 50;  // [ms]
  for (bool is_last = false; !is_last;) {
    is_last = is_ending_;
    pollfd consoles[] = {{STDOUT_FILENO, POLLOUT, 0}, {STDERR_FILENO, POLLOUT, 0}};
    poll(consoles, 1, kPause);
    poll(consoles + 1, 1, kPause);
    if (consoles[0].revents != 0 && consoles[1].revents != 0) {
      return true;
    }
  }
  return false;
}

void LogThread::write() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!waiting_.empty()) {
    const Line line = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    if (!waitForConsole()) {
      return;
    }
    log(line);
    lock.lock();
  }
  const std::uint64_t left_out = std::exchange(left_out_, 0);
  lock.unlock();
  if (left_out > 0 && waitForConsole()) {
    ROS_WARN_STREAM("too much to log at once; lines left out: " << left_out);
  }
}

}  // namespace collision_monitor
