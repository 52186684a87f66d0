// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor::bench {

/// A robot of the shared data whose joints all swing slowly about zero: its joint states, and its
/// tf as robot_state_publisher sends it, in one message for all joints that move.
class MovingRobot {
 public:
  /// The first description in the folder of that name.
  explicit MovingRobot(const std::string& name);

  /// What it is at that time, dated with it.
  void publish(const ros::Time& now);

 private:
  void publishFixed();

  RobotModel model_;
  JointPositions positions_;
  sensor_msgs::JointState joint_states_;
  tf2_msgs::TFMessage transforms_;
  ros::Time start_;  ///< of the swing: each run moves alike
  ros::NodeHandle node_;
  ros::Publisher joint_publisher_;
  ros::Publisher moving_publisher_;
  ros::Publisher fixed_publisher_;
};

}  // namespace collision_monitor::bench
