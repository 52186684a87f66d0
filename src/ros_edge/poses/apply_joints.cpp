// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/apply_joints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "collision_monitor/model/kinematics.h"
#include "model/few_texts.h"
#include "model/joint_type_names.h"
#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/place.h"

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
  std::vector<std::string> accepted;
  for (const Joint& joint : model.joints) {
    if (hasOneVariable(joint) && !joint.mimic) {
      accepted.push_back(joint.name);
    }
  }
  const std::string similar = suggestion(name, accepted);
  const std::string there_are = accepted.empty() ? "; no joint of this robot can be given"
                                                 : "; accepted: " + someOf(accepted);
  return "there is no joint " + quoted(name) + (similar.empty() ? there_are : similar);
}

/// The first entry of each name in a request.
using FirstEntries = std::unordered_map<std::string_view, std::size_t>;

FirstEntries firstEntries(const std::vector<std::string>& names) {
  FirstEntries entries;
  for (std::size_t i = 0; i < names.size(); ++i) {
    entries.emplace(names[i], i);
  }
  return entries;
}

/// The fault of the name of entry `i`; empty if there is none.
/// @pre the model has the joint
std::string fault(const RobotModel& model, const Joint& joint, std::size_t i,
                  const FirstEntries& entries) {
  const std::string named = "joint '" + joint.name + "'";
  if (!hasOneVariable(joint)) {
    return named + " is " + nameOf(joint.type) + ", and a JointState cannot place it; leave it out";
  }
  if (joint.mimic && entries.count(model.joint(joint.mimic->source).name) == 0) {
    return named + " follows '" + model.joint(joint.mimic->source).name + "'; name that one";
  }
  const std::size_t first = entries.at(joint.name);
  return first == i ? "" : named + " stands at [" + std::to_string(first) + "], too; give it once";
}

NamedPositions readPositions(const RobotModel& model, const sensor_msgs::JointState& joints) {
  NamedPositions named{JointPositions(model.variable_count, 0.0),
                       std::vector<unsigned char>(model.variable_count, 0)};
  for (std::size_t i = 0; i < joints.name.size(); ++i) {
    const Joint& joint = model.joint(*model.findJoint(joints.name[i]));
    // A mimic joint follows its source, whatever its own value is.
    if (!joint.mimic) {
      named.positions[joint.first_variable] = joints.position[i];
      named.is_named[joint.first_variable] = 1;
    }
  }
  return named;
}

/// parent_from_child from the named positions, or else from `before`.
std::optional<Pose> jointPose(const Joint& joint, const NamedPositions& named,
                              const LinkPoses& before) {
  const bool is_named = hasOneVariable(joint) && named.is_named[joint.first_variable] != 0;
  const bool is_known = isJoined(before, joint.parent, joint.child);
  if (is_named || (joint.type == JointType::fixed && !is_known)) {
    return parentFromChild(joint, named.positions);
  }
  return is_known ? std::optional(inverse(before.world_from_link[index(joint.parent)]) *
                                  before.world_from_link[index(joint.child)])
                  : std::nullopt;
}

/// The root's pose, if it is known in the world.
std::optional<Pose> rootPose(std::size_t root, const LinkPoses& before) {
  return statusInWorld(before, idAt<LinkId>(root)) == LinkStatus::known
             ? std::optional(before.world_from_link[root])
             : std::nullopt;
}

/// Places a link relative to its parent link; a root in the world.
void placeLink(const RobotModel& model, std::size_t link, const Pose& pose, LinkPoses& poses) {
  poses.status[link] = LinkStatus::known;
  poses.world_from_link[link] = pose;
  if (const auto& joint = model.links[link].parent_joint) {
    const std::size_t parent = index(model.joint(*joint).parent);
    poses.world_from_link[link] = poses.world_from_link[parent] * pose;
    poses.part[link] = poses.part[parent];
    poses.part_status[link] = poses.part_status[parent];
  }
}

}  // namespace

bool takesPositions(const RobotModel& model) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [](const Joint& joint) { return hasOneVariable(joint) && !joint.mimic; });
}

std::string numberFault(double number) {
  return std::abs(number) <= kFarthest ? "" : "is " + shortText(number) + "; accepted: -1e9 to 1e9";
}

std::vector<std::string> jointFaults(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     const std::string& names) {
  if (joints.name.size() != joints.position.size()) {
    return {names + " has " + counted(joints.name.size(), "name") + " for " +
            counted(joints.position.size(), "position") + "; give one position for each name"};
  }
  const FirstEntries entries = firstEntries(joints.name);
  std::unordered_set<std::string_view> unknown;
  FewTexts faults;
  for (std::size_t i = 0; i < joints.name.size(); ++i) {
    const auto place = [&] { return names + "[" + std::to_string(i) + "]: "; };
    const auto id = model.findJoint(joints.name[i]);
    if (!id) {
      if (unknown.insert(joints.name[i]).second) {
        faults.add([&] { return place() + unknownJoint(model, joints.name[i]); });
      }
      continue;
    }
    const std::string text = fault(model, model.joint(*id), i, entries);
    const std::string of_number = numberFault(joints.position[i]);
    if (!text.empty()) {
      faults.add([&] { return place() + text; });
    } else if (!of_number.empty()) {
      faults.add([&] {
        return "joints.position[" + std::to_string(i) + "], of joint " + quoted(joints.name[i]) +
               ", " + of_number;
      });
    }
  }
  return faults.all();
}

std::vector<std::string> applyJoints(const RobotModel& model, const sensor_msgs::JointState& joints,
                                     const std::string& names, LinkPoses& poses) {
  std::vector<std::string> faults = jointFaults(model, joints, names);
  if (!faults.empty()) {
    return faults;
  }
  const NamedPositions named = readPositions(model, joints);
  const LinkPoses before = poses;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& parent_joint = model.links[i].parent_joint;
    const auto pose =
        parent_joint ? jointPose(model.joint(*parent_joint), named, before) : rootPose(i, before);
    if (pose) {
      placeLink(model, i, *pose, poses);
    } else {
      const LinkStatus reason = statusInWorld(before, idAt<LinkId>(i));
      floatFrom(i, reason == LinkStatus::known ? LinkStatus::missing : reason, poses);
    }
  }
  return {};
}

}  // namespace collision_monitor
