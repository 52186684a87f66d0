// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// Asks the second reader about set-ups that are watched already, on a thread of its own. What it
/// finds goes into the log and to the later warnings of the set-up.
class SecondOpinion {
 public:
  SecondOpinion() = default;
  ~SecondOpinion();
  SecondOpinion(const SecondOpinion&) = delete;
  SecondOpinion& operator=(const SecondOpinion&) = delete;

  /// Waits for the last answer, which takes milliseconds, and not for this one. Does not throw: a
  /// set-up without a second opinion is as good as it was.
  void askFor(std::shared_ptr<const MonitorSetup> setup) noexcept;
  /// Waits for the answer.
  void wait();

 private:
  std::mutex mutex_;
  std::thread thread_;
};

}  // namespace collision_monitor
