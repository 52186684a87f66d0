// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ros_edge/poses/joint_store.h"
#include "ros_edge/threads/direct_queue.h"

namespace collision_monitor {

/// Subscribes to topics of joint states and passes messages to a store at once. Ends with this
/// object.
class JointFeed {
 public:
  /// Topics are beside the node, not below it. `after_message` is called on the thread that
  /// delivered the message.
  JointFeed(const ros::NodeHandle& private_node, JointStore& store,
            std::function<void()> after_message);

  /// Listens to these topics only; "" is no topic. Not for several threads at once.
  void listenTo(const std::vector<std::string>& topics);

 private:
  JointStore& store_;
  std::function<void()> after_message_;
  DirectQueue queue_;  ///< outlives the subscribers
  ros::NodeHandle private_node_;
  std::map<std::string, ros::Subscriber> subscribers_;
};

}  // namespace collision_monitor
