// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <cstdint>
#include <mutex>

namespace collision_monitor {

/// No queue: callbacks run at once, on the thread that brings the message, which is roscpp's
/// network thread or that of a publisher in the same process. No other callback delays them, and
/// no thread has to wake for them. Only for callbacks that merely store what came: all other
/// messages wait meanwhile, and they may not subscribe or unsubscribe. After a subscriber has
/// ended, its callback does not run any more; the queue must outlive its subscribers.
class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t /*owner*/) override {
    // One at a time: roscpp gives a callback up that is asked for while it runs.
    const std::lock_guard<std::mutex> lock(mutex_);
    callback->call();
  }
  void removeByID(std::uint64_t /*owner*/) override {}

 private:
  std::mutex mutex_;
};

}  // namespace collision_monitor
