// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include "collision_monitor/ros_edge/feed_thread.h"
#include "collision_monitor/ros_edge/transform_store.h"

namespace collision_monitor {

/// Subscribes to tf and tf_static on a thread of its own and feeds a store. Stops with its life.
class TransformFeed {
 public:
  TransformFeed(const ros::NodeHandle& node, TransformStore& store);

 private:
  TransformStore& store_;
  FeedThread thread_;  ///< ends after the subscribers, which wait for callbacks that run
  ros::Subscriber moving_;
  ros::Subscriber static_;
};

}  // namespace collision_monitor
