// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/log_thread.h"

#include <ros/console.h>

namespace collision_monitor {

LogThread::LogThread() : thread_([this] { write(); }) {}

void LogThread::push(const Line& line) {
  left_out_ += waiting_.push(line) ? 0 : 1;
  thread_.wake();
}

void LogThread::write() {
  Line line;
  while (waiting_.pop(line)) {
    if (line.is_warning) {
      ROS_WARN_STREAM(line.text);
    } else {
      ROS_INFO_STREAM(line.text);
    }
  }
  if (const std::uint64_t left_out = left_out_.exchange(0)) {
    ROS_WARN_STREAM("the log is too slow: lines left out: " << left_out);
  }
}

}  // namespace collision_monitor
