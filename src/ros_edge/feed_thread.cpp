// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/feed_thread.h"

namespace collision_monitor {

FeedThread::FeedThread(const ros::NodeHandle& node) : node_(node) {
  node_.setCallbackQueue(&queue_);
  thread_ = std::thread([this] {
    constexpr double kLongestWait = 0.05;
    while (is_running_) {
      queue_.callAvailable(ros::WallDuration(kLongestWait));
    }
  });
}

FeedThread::~FeedThread() {
  is_running_ = false;
  queue_.disable();
  thread_.join();
}

}  // namespace collision_monitor
