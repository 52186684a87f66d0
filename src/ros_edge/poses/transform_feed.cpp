// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/transform_feed.h"

namespace collision_monitor {

TransformFeed::TransformFeed(ros::NodeHandle node, TransformStore& store) : store_(store) {
  node.setCallbackQueue(&queue_);
  constexpr std::uint32_t kQueueSize = 100;
  using TransformEvent = ros::MessageEvent<tf2_msgs::TFMessage const>;
  const auto subscribe = [&](const char* topic, bool is_static) {
    const boost::function<void(const TransformEvent&)> callback =
        [this, is_static](const TransformEvent& event) {
          store_.accept(event.getConstMessage()->transforms, is_static, event.getPublisherName());
        };
    return node.subscribe<tf2_msgs::TFMessage, const TransformEvent&>(
        topic, kQueueSize, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  };
  moving_ = subscribe("/tf", false);
  static_ = subscribe("/tf_static", true);
}

}  // namespace collision_monitor
