// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <string>

#include "ros_edge/woken_thread.h"

namespace collision_monitor {

/// Logs lines on a thread of its own: a console is slow, and stands still while its user reads.
/// Lines come from one thread, which never waits: beyond 1000 that wait, they are left out, and
/// counted in a line.
class LogThread {
 public:
  LogThread();
  void info(const std::string& line) { push({line, false}); }
  void warn(const std::string& line) { push({line, true}); }

 private:
  struct Line {
    std::string text;
    bool is_warning{false};
  };
  static constexpr std::size_t kMostWaiting = 1000;

  void push(const Line& line);
  void write();

  boost::lockfree::spsc_queue<Line, boost::lockfree::capacity<kMostWaiting>> waiting_;
  std::atomic<std::uint64_t> left_out_{0};
  WokenThread thread_;  ///< last: it uses the others
};

}  // namespace collision_monitor
