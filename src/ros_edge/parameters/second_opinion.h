// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/threads/log_thread.h"

namespace collision_monitor {

/// Runs the second reader on its own thread for a set-up that is already monitored. Differences go
/// into the log and to the set-up's later warnings.
class SecondOpinion {
 public:
  /// @pre the log outlives it
  explicit SecondOpinion(LogThread& log) : log_(log) {}
  ~SecondOpinion();
  SecondOpinion(const SecondOpinion&) = delete;
  SecondOpinion& operator=(const SecondOpinion&) = delete;

  /// Waits for the previous answer, which takes milliseconds, but not for this one. Does not throw:
  /// the set-up works without a second opinion.
  void askFor(std::shared_ptr<const MonitorSetup> setup) noexcept;
  /// Waits for the answer.
  void wait();

 private:
  LogThread& log_;
  std::mutex mutex_;
  std::thread thread_;
};

}  // namespace collision_monitor
