// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/joint_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace collision_monitor {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The name in the URDF, without the robot's prefix.
std::string bareName(const Robot& robot, const std::string& name) {
  const std::string front = robot.tf_prefix + "/";
  return name.compare(0, front.size(), front) == 0 ? name.substr(front.size()) : name;
}

bool isFresh(const JointSample& sample, const ros::Time& now, double max_age) {
  const auto now_ns = static_cast<std::int64_t>(now.toNSec());
  return std::abs(1e-9 * static_cast<double>(now_ns - sample.stamp_ns)) <= max_age;
}

}  // namespace

JointReader::JointReader(const RobotModel& model, const JointStore& store,
                         std::vector<std::string> topics)
    : model_(model), store_(store), topics_(std::move(topics)), newest_(model.variable_count) {
  variables_.reserve(model.joints.size());
  records_.reserve(model.joints.size());
  newest_samples_.reserve(model.joints.size());
  samples_.reserve(model.joints.size());
}

void JointReader::findJoints() {
  if (store_.recordCount() == known_records_) {
    return;
  }
  known_records_ = store_.recordCount();
  variables_.clear();
  records_.clear();
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    const Robot& robot = model_.robots[i];
    for (std::size_t k = 0; k < robot.joint_count; ++k) {
      const Joint& joint = model_.joints[robot.first_joint + k];
      const bool has_own_variable = freedomOf(joint) == 1 && !joint.mimic;
      const auto record = has_own_variable ? find(i, joint) : std::nullopt;
      if (record) {
        variables_.push_back(joint.first_variable);
        records_.push_back({*record, joint.type == JointType::continuous});
      }
    }
  }
}

std::optional<JointStore::Record> JointReader::find(std::size_t robot, const Joint& joint) const {
  const auto record = store_.find(topics_[robot], joint.name);
  const std::string bare = bareName(model_.robots[robot], joint.name);
  return record || hasOtherRobotJoint(robot, bare) ? record : store_.find(topics_[robot], bare);
}

/// Whether another robot's joint on the same topic has the same name apart from the prefix.
bool JointReader::hasOtherRobotJoint(std::size_t robot, const std::string& bare_name) const {
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    const Robot& other = model_.robots[i];
    for (std::size_t k = 0; k < other.joint_count; ++k) {
      if (i != robot && topics_[i] == topics_[robot] &&
          bareName(other, model_.joints[other.first_joint + k].name) == bare_name) {
        return true;
      }
    }
  }
  return false;
}

void JointReader::refresh() {
  findJoints();
  store_.readNewest(records_, newest_samples_);
  for (std::size_t i = 0; i < newest_samples_.size(); ++i) {
    newest_[variables_[i]] = newest_samples_[i];
  }
}

Refusal JointReader::refusedAhead(std::size_t variable) const {
  const auto place = std::find(variables_.begin(), variables_.end(), variable);
  return place == variables_.end()
             ? Refusal()
             : store_.refusedAhead(
                   records_[static_cast<std::size_t>(place - variables_.begin())].record);
}

void JointReader::readPositions(std::int64_t stamp_ns, double longest_gap,
                                JointPositions& positions) {
  std::fill(positions.begin(), positions.end(), kNaN);
  store_.readAt(records_, stamp_ns, longest_gap, samples_);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    positions[variables_[i]] = samples_[i].position;
  }
}

void JointReader::readNewestPositions(const ros::Time& now, double max_age,
                                      JointPositions& positions) const {
  for (std::size_t i = 0; i < newest_.size(); ++i) {
    positions[i] = isFresh(newest_[i], now, max_age) ? newest_[i].position : kNaN;
  }
}

void JointReader::readVelocities(const ros::Time& now, double max_age,
                                 JointVelocities& velocities) const {
  for (std::size_t i = 0; i < newest_.size(); ++i) {
    const bool is_usable = isFresh(newest_[i], now, max_age) && std::isfinite(newest_[i].velocity);
    velocities[i] = is_usable ? newest_[i].velocity : kNaN;
  }
}

std::vector<std::string> jointNames(const RobotModel& model, RobotId robot) {
  const Robot& one = model.robots[index(robot)];
  std::vector<std::string> names;
  for (std::size_t i = one.first_joint; i < one.first_joint + one.joint_count; ++i) {
    names.push_back(model.joints[i].name);
    names.push_back(bareName(one, model.joints[i].name));
  }
  return names;
}

}  // namespace collision_monitor
