// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

#include "ros_edge/threads/inheriting_mutex.h"
#include "ros_edge/threads/woken_thread.h"

namespace collision_monitor {

/// Logs lines on a thread of its own: a console is slow, and stands still while its user reads. Any
/// thread may add lines. Beyond 20,000 that wait, they are left out, and counted in a line.
class LogThread {
 public:
  LogThread();
  /// Logs what waits, unless the console stands still.
  ~LogThread();
  LogThread(const LogThread&) = delete;
  LogThread& operator=(const LogThread&) = delete;

  void info(std::string text) { add({std::move(text), Level::info}); }
  void warn(std::string text) { add({std::move(text), Level::warning}); }
  void error(std::string text) { add({std::move(text), Level::error}); }

 private:
  enum class Level : unsigned char { info, warning, error };
  struct Line {
    std::string text;
    Level level{Level::info};
  };

  void add(Line line);
  static void log(const Line& line);
  bool waitForConsole() const;
  void write();

  InheritingMutex mutex_;  ///< guards the next two
  std::deque<Line> waiting_;
  std::uint64_t left_out_{0};
  std::atomic<bool> is_ending_{false};
  WokenThread thread_;  ///< last: it uses the others
};

}  // namespace collision_monitor
