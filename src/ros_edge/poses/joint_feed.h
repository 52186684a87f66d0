// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ros_edge/direct_queue.h"
#include "ros_edge/poses/joint_store.h"

namespace collision_monitor {

/// Subscribes to topics of joint states and feeds a store with what comes, at once. Stops with its
/// life.
class JointFeed {
 public:
  /// Topics are beside the node, not below it. `after_message` is called on the thread that brought
  /// it.
  JointFeed(const ros::NodeHandle& private_node, JointStore& store,
            std::function<void()> after_message);

  /// Listens to these topics, and to no others any more; "" is none. From one thread at a time.
  void listenTo(const std::vector<std::string>& topics);

 private:
  JointStore& store_;
  std::function<void()> after_message_;
  DirectQueue queue_;  ///< ends after the subscribers
  ros::NodeHandle private_node_;
  std::map<std::string, ros::Subscriber> subscribers_;
};

}  // namespace collision_monitor
