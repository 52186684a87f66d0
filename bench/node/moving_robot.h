// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor::bench {

/// A robot of the shared data whose joints all swing slowly and together, each by a tenth of its
/// range to either side. Publishes its joint states, and its tf as robot_state_publisher does: in
/// one message for all moving joints.
class MovingRobot {
 public:
  /// The first description in the folder of that name. It swings about zero, or as near to zero as
  /// the limits allow.
  explicit MovingRobot(const std::string& name);

  /// The joints that swing, in the order of all positions below.
  const std::vector<std::string>& jointNames() const { return joint_states_.name; }

  /// @return a random middle of a swing; the same for the same seed.
  std::vector<double> randomMiddle(unsigned seed) const;

  /// @param at  -1 at one end of the swing, 1 at the other.
  std::vector<double> swingFrom(const std::vector<double>& middle, double at) const;

  /// @param middle  as from randomMiddle().
  void swingAbout(const std::vector<double>& middle) { middle_ = middle; }

  /// Publishes its state at that time, with that stamp.
  void publish(const ros::Time& now);

 private:
  void publishFixed();

  RobotModel model_;
  std::vector<const Joint*> joints_;  ///< those that swing
  std::vector<double> middle_;
  JointPositions positions_;
  sensor_msgs::JointState joint_states_;
  tf2_msgs::TFMessage transforms_;
  ros::Time start_;  ///< of the swing, so that each run moves alike
  ros::NodeHandle node_;
  ros::Publisher joint_publisher_;
  ros::Publisher moving_publisher_;
  ros::Publisher fixed_publisher_;
};

}  // namespace collision_monitor::bench
