// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <boost/interprocess/sync/interprocess_semaphore.hpp>
#include <functional>
#include <thread>

namespace collision_monitor {

/// Does on its own thread what takes the cycle's thread too long.
class WokenThread {
 public:
  /// @param work what to do after each wake, and once at the end; does not throw
  explicit WokenThread(std::function<void()> work);
  /// Waits until the work is done.
  ~WokenThread();
  WokenThread(const WokenThread&) = delete;
  WokenThread& operator=(const WokenThread&) = delete;

  /// Takes no lock and never waits.
  void wake() { woken_.post(); }

 private:
  void run();

  std::function<void()> work_;
  boost::interprocess::interprocess_semaphore woken_{0};
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

}  // namespace collision_monitor
