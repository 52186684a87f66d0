// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/RobotState.h>
#include <collision_monitor/State.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// The meaning of state_is_valid, as in cob_collision_monitor: false stops the listeners. A monitor
/// that is uncertain or switched off guarantees nothing.
inline bool vouchesFor(bool is_enabled, std::uint8_t level) {
  return is_enabled && (level == State::OK || level == State::WARNING);
}

/// robots/NAME/speed_scale and robots/NAME/state_is_valid for each robot of the parameter `robots`,
/// with types and meaning of the topics for all robots; latched. Late listeners get the last
/// message, so without listeners only changes are sent.
class RobotTopics {
 public:
  /// Asks the ROS master for each topic that is new: not on the cycle's thread.
  /// @param former keeps its topics; may be null. Those of a robot that is no longer listed stay,
  /// with 0 and false: who listens must not go on with the last value.
  RobotTopics(ros::NodeHandle& private_node, const std::vector<RobotSource>& robots,
              const RobotTopics* former);

  /// For the cycle's thread.
  void publish(const std::vector<RobotState>& states, bool is_enabled);
  /// Finds out who listens, which takes a lock.
  void askWhoListens();

 private:
  struct Topic {
    ros::Publisher speed_scale;
    ros::Publisher is_valid;
    std::optional<double> last_scale;
    std::optional<bool> last_valid;
    bool is_scale_heard{false};
    bool is_valid_heard{false};
  };
  std::map<std::string, Topic> topics_;  ///< by name of robot
};

}  // namespace collision_monitor
