// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include "ros_edge/poses/transform_store.h"
#include "ros_edge/threads/direct_queue.h"

namespace collision_monitor {

/// Subscribes to tf and tf_static and passes messages to a store at once. Ends with this object.
class TransformFeed {
 public:
  TransformFeed(ros::NodeHandle node, TransformStore& store);

 private:
  TransformStore& store_;
  DirectQueue queue_;  ///< outlives the subscribers
  ros::Subscriber moving_;
  ros::Subscriber static_;
};

}  // namespace collision_monitor
