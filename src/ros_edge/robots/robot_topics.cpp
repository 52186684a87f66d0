// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/robot_topics.h"

#include <collision_monitor/State.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include "ros_edge/latched_value.h"

namespace collision_monitor {
namespace {

constexpr std::uint32_t kRobotQueueSize = 10;

}  // namespace

RobotTopics::RobotTopics(ros::NodeHandle& private_node, const std::vector<RobotSource>& robots,
                         const RobotTopics* former) {
  for (const RobotSource& robot : robots) {
    Topic& topic = topics_[robot.name];
    if (former != nullptr) {
      const auto known = former->topics_.find(robot.name);
      if (known != former->topics_.end()) {
        topic.speed_scale = known->second.speed_scale;
        topic.is_valid = known->second.is_valid;
        continue;
      }
    }
    const std::string place = "robots/" + robot.name;
    topic.speed_scale =
        private_node.advertise<std_msgs::Float64>(place + "/speed_scale", kRobotQueueSize, true);
    topic.is_valid =
        private_node.advertise<std_msgs::Bool>(place + "/state_is_valid", kRobotQueueSize, true);
  }
}

void RobotTopics::askWhoListens() {
  for (auto& [name, topic] : topics_) {
    topic.is_scale_heard = topic.speed_scale.getNumSubscribers() > 0;
    topic.is_valid_heard = topic.is_valid.getNumSubscribers() > 0;
  }
}

void RobotTopics::publish(const std::vector<RobotState>& states, bool is_enabled) {
  for (const RobotState& state : states) {
    const auto topic = topics_.find(state.name);
    if (topic == topics_.end()) {
      continue;  // a single robot that the parameter `robots` does not list
    }
    const bool is_valid = is_enabled && (state.level == State::OK || state.level == State::WARNING);
    publishLatched<std_msgs::Bool>(is_valid, topic->second.is_valid_heard, topic->second.is_valid,
                                   topic->second.last_valid);
    publishLatched<std_msgs::Float64>(state.speed_scale, topic->second.is_scale_heard,
                                      topic->second.speed_scale, topic->second.last_scale);
  }
}

}  // namespace collision_monitor
