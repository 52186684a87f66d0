// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <thread>

#include "collision_monitor/ros_edge/transform_store.h"

namespace collision_monitor {

/// Subscribes to tf and tf_static on a queue and thread of its own, so that no other
/// callback delays them, and feeds a store. Stops with its life.
class TransformFeed {
 public:
  TransformFeed(const ros::NodeHandle& node, TransformStore& store);
  ~TransformFeed();
  TransformFeed(const TransformFeed&) = delete;
  TransformFeed& operator=(const TransformFeed&) = delete;

 private:
  TransformStore& store_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber moving_;
  ros::Subscriber static_;
  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace collision_monitor
