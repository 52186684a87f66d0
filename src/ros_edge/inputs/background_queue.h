// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <thread>

namespace collision_monitor {

/// A callback queue with one thread of its own, for callbacks that take seconds: they run one
/// after the other, hold up no callback of other queues, and yield the processor to threads of
/// usual priority, the cycle above all.
class BackgroundQueue {
 public:
  BackgroundQueue();
  /// Ends when the callback at hand does.
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// Must not be used any more when this ends.
  ros::CallbackQueue& queue() noexcept { return queue_; }
  /// Asks callbacks that look at isEnding to give up. No callback begins after that.
  void end() noexcept { is_ending_ = true; }
  bool isEnding() const noexcept { return is_ending_; }

 private:
  void run();

  ros::CallbackQueue queue_;
  std::atomic<bool> is_ending_{false};
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace collision_monitor
