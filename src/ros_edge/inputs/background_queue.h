// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <thread>

namespace collision_monitor {

/// A callback queue with its own thread, for callbacks that take seconds. They run one after the
/// other and do not delay callbacks of other queues. They yield the processor to threads of normal
/// priority, above all to the cycle.
class BackgroundQueue {
 public:
  BackgroundQueue();
  /// Waits for the current callback.
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// Must not be used after this object's end.
  ros::CallbackQueue& queue() noexcept { return queue_; }
  /// Asks callbacks to give up, if they check isEnding. No new callback starts afterwards.
  void end() noexcept { is_ending_ = true; }
  bool isEnding() const noexcept { return is_ending_; }

 private:
  void run();

  ros::CallbackQueue queue_;
  std::atomic<bool> is_ending_{false};
  std::thread thread_;  ///< last: uses the members above
};

}  // namespace collision_monitor
