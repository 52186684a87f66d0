// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <cstdint>
#include <mutex>

namespace collision_monitor {

/// Not a queue: runs callbacks at once, on the thread that delivers the message: roscpp's network
/// thread, or that of a publisher in the same process. Other callbacks do not delay them, and no
/// thread has to wake up. Only for callbacks that merely store a message: they block all other
/// messages, and must not subscribe or unsubscribe. A callback never runs after its subscriber has
/// ended. The queue must outlive its subscribers.
class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t /*owner*/) override {
    // One at a time: roscpp drops a callback that is called while it runs.
    const std::lock_guard<std::mutex> lock(mutex_);
    callback->call();
  }
  void removeByID(std::uint64_t /*owner*/) override {}

 private:
  std::mutex mutex_;
};

}  // namespace collision_monitor
