// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/joint_feed.h"

#include <utility>

#include "ros_edge/name_beside.h"

namespace collision_monitor {

JointFeed::JointFeed(const ros::NodeHandle& private_node, JointStore& store,
                     std::function<void()> after_message)
    : store_(store), after_message_(std::move(after_message)), private_node_(private_node) {
  private_node_.setCallbackQueue(&queue_);
}

void JointFeed::listenTo(const std::vector<std::string>& topics) {
  std::map<std::string, ros::Subscriber> wanted;
  constexpr std::uint32_t kQueueSize = 100;
  for (const std::string& topic : topics) {
    const auto known = subscribers_.find(topic);
    if (known != subscribers_.end()) {
      wanted.insert(*known);
    }
    if (topic.empty() || wanted.count(topic) > 0) {
      continue;
    }
    using JointEvent = ros::MessageEvent<sensor_msgs::JointState const>;
    const boost::function<void(const JointEvent&)> callback = [this,
                                                               topic](const JointEvent& event) {
      store_.accept(topic, *event.getConstMessage(), event.getPublisherName());
      after_message_();
    };
    wanted[topic] = private_node_.subscribe<sensor_msgs::JointState, const JointEvent&>(
        nameBeside(private_node_, topic), kQueueSize, callback, ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay());
  }
  subscribers_ = std::move(wanted);
}

}  // namespace collision_monitor
