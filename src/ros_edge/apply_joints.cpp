// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/apply_joints.h"

#include <cmath>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "collision_monitor/model/kinematics.h"
#include "model/number_text.h"
#include "ros_edge/few_texts.h"
#include "ros_edge/nearest_name.h"

namespace collision_monitor {
namespace {

struct NamedPositions {
  JointPositions positions;
  std::vector<unsigned char> is_named;  ///< by variable
};

bool hasOneVariable(const Joint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous ||
         joint.type == JointType::prismatic;
}

std::string unknownJoint(const RobotModel& model, const std::string& name) {
  std::vector<std::string> known;
  for (const Joint& joint : model.joints) {
    known.push_back(joint.name);
  }
  return "there is no joint '" + name + "'" + suggestion(name, known);
}

/// How often each name stands in a request.
using NameCounts = std::unordered_map<std::string_view, std::size_t>;

NameCounts countNames(const std::vector<std::string>& names) {
  NameCounts counts;
  for (const std::string& name : names) {
    ++counts[name];
  }
  return counts;
}

/// What is wrong with one entry; empty if nothing is.
/// @pre the model has the joint
std::string fault(const RobotModel& model, const Joint& joint, double position,
                  const NameCounts& counts) {
  const std::string named = "joint '" + joint.name + "'";
  if (!hasOneVariable(joint)) {
    return named + " is fixed, planar or floating, and a JointState cannot place it; leave it out";
  }
  if (joint.mimic && counts.count(model.joint(joint.mimic->source).name) == 0) {
    return named + " follows '" + model.joint(joint.mimic->source).name + "'; name that one";
  }
  const std::string of_number = numberFault(position);
  if (!of_number.empty()) {
    return "the position of " + named + " " + of_number;
  }
  return counts.at(joint.name) > 1 ? named + " stands twice" : "";
}

NamedPositions readPositions(const RobotModel& model, const sensor_msgs::JointState& joints) {
  NamedPositions named{JointPositions(model.variable_count, 0.0),
                       std::vector<unsigned char>(model.variable_count, 0)};
  for (std::size_t i = 0; i < joints.name.size(); ++i) {
    const Joint& joint = model.joint(*model.findJoint(joints.name[i]));
    // The value of a mimic joint follows from that of its source.
    if (!joint.mimic) {
      named.positions[joint.first_variable] = joints.position[i];
      named.is_named[joint.first_variable] = 1;
    }
  }
  return named;
}

}  // namespace

std::string numberFault(double number) {
  if (!std::isfinite(number)) {
    return "is not finite";
  }
  return std::abs(number) <= kFarthest ? "" : "is " + shortText(number) + "; accepted: -1e9 to 1e9";
}

std::vector<std::string> jointFaults(const RobotModel& model,
                                     const sensor_msgs::JointState& joints) {
  if (joints.name.size() != joints.position.size()) {
    return {"joints has " + std::to_string(joints.name.size()) + " names and " +
            std::to_string(joints.position.size()) + " positions; give one position for each name"};
  }
  const NameCounts counts = countNames(joints.name);
  std::unordered_set<std::string_view> unknown;
  FewTexts faults;
  for (std::size_t i = 0; i < joints.name.size(); ++i) {
    const auto id = model.findJoint(joints.name[i]);
    if (!id) {
      if (unknown.insert(joints.name[i]).second) {
        faults.add([&] { return unknownJoint(model, joints.name[i]); });
      }
      continue;
    }
    std::string text = fault(model, model.joint(*id), joints.position[i], counts);
    if (!text.empty()) {
      faults.add([&] { return text; });
    }
  }
  return faults.all();
}

std::vector<std::string> applyJoints(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     LinkPoses& poses) {
  std::vector<std::string> faults = jointFaults(model, joints);
  if (!faults.empty()) {
    return faults;
  }
  const NamedPositions named = readPositions(model, joints);
  const LinkPoses before = poses;
  const auto is_known = [&](std::size_t link) { return before.status[link] == LinkStatus::known; };
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!model.links[i].parent_joint) {
      continue;
    }
    const Joint& joint = model.joint(*model.links[i].parent_joint);
    const std::size_t parent = index(joint.parent);
    const bool is_named = hasOneVariable(joint) && named.is_named[joint.first_variable] != 0;
    Pose parent_from_child;
    LinkStatus status = poses.status[parent];
    if (is_named || (joint.type == JointType::fixed && !is_known(i))) {
      parent_from_child = parentFromChild(joint, named.positions);
    } else if (is_known(i) && is_known(parent)) {
      parent_from_child = inverse(before.world_from_link[parent]) * before.world_from_link[i];
    } else if (status == LinkStatus::known) {
      status = is_known(i) ? LinkStatus::missing : before.status[i];
    }
    poses.status[i] = status;
    poses.world_from_link[i] = poses.world_from_link[parent] * parent_from_child;
  }
  return {};
}

}  // namespace collision_monitor
