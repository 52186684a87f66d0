// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// Runs the second reader on its own thread for a set-up that is already monitored. Differences go
/// into the log and to the set-up's later warnings.
class SecondOpinion {
 public:
  SecondOpinion() = default;
  ~SecondOpinion();
  SecondOpinion(const SecondOpinion&) = delete;
  SecondOpinion& operator=(const SecondOpinion&) = delete;

  /// Waits for the previous answer, which takes milliseconds, but not for this one. Does not throw:
  /// the set-up works without a second opinion.
  void askFor(std::shared_ptr<const MonitorSetup> setup) noexcept;
  /// Waits for the answer.
  void wait();

 private:
  std::mutex mutex_;
  std::thread thread_;
};

}  // namespace collision_monitor
