// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/robot_topics.h"

#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include <algorithm>

#include "ros_edge/latched_value.h"

namespace collision_monitor {
namespace {

constexpr std::uint32_t kRobotQueueSize = 10;

}  // namespace

RobotTopics::RobotTopics(ros::NodeHandle& private_node, const std::vector<RobotSource>& robots,
                         const RobotTopics* former) {
  if (former != nullptr) {
    for (const auto& [name, topic] : former->topics_) {
      topics_[name].speed_scale = topic.speed_scale;  // the rest is the cycle's
      topics_[name].is_valid = topic.is_valid;
    }
  }
  for (const RobotSource& robot : robots) {
    Topic& topic = topics_[robot.name];
    if (topic.speed_scale) {
      continue;
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
  for (auto& known : topics_) {
    const auto state = std::find_if(states.begin(), states.end(), [&](const RobotState& robot) {
      return robot.name == known.first;
    });
    Topic& topic = known.second;
    const bool is_listed = state != states.end();
    const double speed_scale = is_listed ? state->speed_scale : 0.0;
    const bool is_valid = is_listed && vouchesFor(is_enabled, state->level);
    publishLatched<std_msgs::Bool>(is_valid, topic.is_valid_heard, topic.is_valid,
                                   topic.last_valid);
    publishLatched<std_msgs::Float64>(speed_scale, topic.is_scale_heard, topic.speed_scale,
                                      topic.last_scale);
  }
}

}  // namespace collision_monitor
