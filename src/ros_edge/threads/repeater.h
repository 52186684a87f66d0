// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace collision_monitor {

/// Calls a function on its own thread again and again, by wall time.
class Repeater {
 public:
  /// @param pause between two calls, and before the first
  /// @param call does not throw
  Repeater(std::chrono::milliseconds pause, std::function<void()> call);
  /// Waits for the current call.
  ~Repeater();
  Repeater(const Repeater&) = delete;
  Repeater& operator=(const Repeater&) = delete;

 private:
  void run(std::chrono::milliseconds pause);

  std::function<void()> call_;
  std::mutex mutex_;  ///< guards the next two
  std::condition_variable woken_;
  bool is_ending_{false};
  std::thread thread_;
};

}  // namespace collision_monitor
