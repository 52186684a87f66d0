// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/transform_feed.h"

namespace collision_monitor {

TransformFeed::TransformFeed(ros::NodeHandle node, TransformStore& store) : store_(store) {
  node.setCallbackQueue(&queue_);
  constexpr std::uint32_t kQueueSize = 100;
  const auto subscribe = [&](const char* topic, bool is_static) {
    const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> callback =
        [this, is_static](const tf2_msgs::TFMessageConstPtr& message) {
          store_.accept(message->transforms, is_static);
        };
    return node.subscribe<tf2_msgs::TFMessage>(topic, kQueueSize, callback, ros::VoidConstPtr(),
                                               ros::TransportHints().tcpNoDelay());
  };
  moving_ = subscribe("/tf", false);
  static_ = subscribe("/tf_static", true);
}

}  // namespace collision_monitor
