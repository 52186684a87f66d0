// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "moving_robot.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "support/robots/file_loader.h"

namespace collision_monitor::bench {
namespace {

constexpr double kFrequency = 0.5;  // [rad/s]
constexpr double kReach = 0.1;      // of the range between the limits, to either side

/// Reads the robot without its meshes, which have no effect on its motion.
RobotModel readRobot(const std::string& name) {
  for (const test::RobotFile& robot : test::allRobotFiles()) {
    if (robot.name.substr(0, robot.name.find('/')) == name) {
      SetupReport report;
      return readRobots({test::describe(robot)}, test::oneTriangleLoader(), report);
    }
  }
  throw std::runtime_error("no shared robot is called " + name);
}

double amplitudeOf(const Joint& joint) {
  const double range = joint.upper - joint.lower;
  return kReach * (std::isfinite(range) ? range : 2.0);
}

/// The nearest position about which the swing stays within the limits.
double middleNear(const Joint& joint, double position) {
  const double swing = amplitudeOf(joint);
  return std::min(std::max(position, joint.lower + swing), joint.upper - swing);
}

bool hasOwnVariable(const Joint& joint) { return freedomOf(joint) == 1 && !joint.mimic; }

geometry_msgs::TransformStamped toTransform(const RobotModel& model, const Joint& joint,
                                            const JointPositions& positions) {
  const Pose pose = parentFromChild(joint, positions);
  const Eigen::Quaterniond rotation(pose.rotation);
  geometry_msgs::TransformStamped message;
  message.header.frame_id = model.link(joint.parent).frame;
  message.child_frame_id = model.link(joint.child).frame;
  message.transform.translation.x = pose.translation.x();
  message.transform.translation.y = pose.translation.y();
  message.transform.translation.z = pose.translation.z();
  message.transform.rotation.x = rotation.x();
  message.transform.rotation.y = rotation.y();
  message.transform.rotation.z = rotation.z();
  message.transform.rotation.w = rotation.w();
  return message;
}

}  // namespace

MovingRobot::MovingRobot(const std::string& name)
    : model_(readRobot(name)),
      positions_(defaultPositions(model_)),
      joint_publisher_(node_.advertise<sensor_msgs::JointState>("joint_states", 10)),
      moving_publisher_(node_.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      fixed_publisher_(node_.advertise<tf2_msgs::TFMessage>("/tf_static", 100, true)) {
  for (const Joint& joint : model_.joints) {
    if (hasOwnVariable(joint)) {
      joints_.push_back(&joint);
      joint_states_.name.push_back(joint.name);
      middle_.push_back(middleNear(joint, 0.0));
    }
  }
  publishFixed();
}

std::vector<double> MovingRobot::randomMiddle(unsigned seed) const {
  std::mt19937 generator(seed);
  std::vector<double> middle;
  for (const Joint* joint : joints_) {
    const double lower = std::max(joint->lower, -M_PI);  // joints without limits turn
    const double upper = std::min(joint->upper, M_PI);
    middle.push_back(
        middleNear(*joint, std::uniform_real_distribution<double>(lower, upper)(generator)));
  }
  return middle;
}

std::vector<double> MovingRobot::swingFrom(const std::vector<double>& middle, double at) const {
  std::vector<double> positions = middle;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    positions[i] += at * amplitudeOf(*joints_[i]);
  }
  return positions;
}

void MovingRobot::publishFixed() {
  tf2_msgs::TFMessage fixed;
  for (const Joint& joint : model_.joints) {
    if (joint.type == JointType::fixed) {
      fixed.transforms.push_back(toTransform(model_, joint, positions_));
      fixed.transforms.back().header.stamp = ros::Time::now();
    }
  }
  fixed_publisher_.publish(fixed);
}

void MovingRobot::publish(const ros::Time& now) {
  start_ = start_.isZero() ? now : start_;
  const double phase = kFrequency * (now - start_).toSec();
  joint_states_.header.stamp = now;
  joint_states_.position = swingFrom(middle_, std::sin(phase));
  joint_states_.velocity.clear();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    positions_[joints_[i]->first_variable] = joint_states_.position[i];
    joint_states_.velocity.push_back(kFrequency * amplitudeOf(*joints_[i]) * std::cos(phase));
  }
  transforms_.transforms.clear();
  for (const Joint& joint : model_.joints) {
    if (joint.type != JointType::fixed) {
      transforms_.transforms.push_back(toTransform(model_, joint, positions_));
      transforms_.transforms.back().header.stamp = now;
    }
  }
  joint_publisher_.publish(joint_states_);
  moving_publisher_.publish(transforms_);
}

}  // namespace collision_monitor::bench
