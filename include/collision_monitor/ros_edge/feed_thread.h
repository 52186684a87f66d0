// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <thread>

namespace collision_monitor {

/// A callback queue with a thread of its own, so that no other callback delays what is subscribed
/// by its node handle. Stops with its life; subscribers end before it.
class FeedThread {
 public:
  explicit FeedThread(const ros::NodeHandle& node);
  ~FeedThread();
  FeedThread(const FeedThread&) = delete;
  FeedThread& operator=(const FeedThread&) = delete;

  ros::NodeHandle& node() noexcept { return node_; }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace collision_monitor
