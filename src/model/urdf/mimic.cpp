// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "model/urdf/link_tree.h"

namespace collision_monitor {
namespace {

using JointsByName = std::map<std::string, std::size_t>;

bool hasOneVariable(JointType type) {
  return type == JointType::revolute || type == JointType::continuous ||
         type == JointType::prismatic;
}

/// What the joint follows directly, after checks.
std::optional<ResolvedMimic> resolveOne(const UrdfRobot& robot, const JointsByName& index_of,
                                        const UrdfJoint& joint, const Place& place) {
  const UrdfMimic& mimic = *joint.mimic;
  const Place here = place.within("joint " + quoted(joint.joint.name));
  const auto found = index_of.find(mimic.source);
  if (found == index_of.end()) {
    // Not an error: robot_state_publisher and MoveIt accept such a robot, and joint states give the
    // joint's position.
    place.within("joint " + quoted(joint.joint.name) + " of " + quoted(mimic.source))
        .note(Oddity::mimic_of_unknown_joint);
    return std::nullopt;
  }
  const JointType source_type = robot.joints[found->second].joint.type;
  if (source_type == JointType::fixed) {
    here.note(Oddity::mimic_of_immovable_joint);
    return std::nullopt;
  }
  if (!hasOneVariable(source_type)) {
    here.addError(joint.line, "mimic of " + quoted(mimic.source) + ", which has several variables",
                  "mimic of a revolute, continuous or prismatic joint");
    return std::nullopt;
  }
  return ResolvedMimic{found->second, mimic.multiplier, mimic.offset};
}

}  // namespace

std::vector<std::optional<ResolvedMimic>> resolveMimics(const UrdfRobot& robot,
                                                        const Place& place) {
  JointsByName index_of;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    index_of.emplace(robot.joints[i].joint.name, i);
  }
  std::vector<std::optional<ResolvedMimic>> direct(robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].mimic) {
      direct[i] = resolveOne(robot, index_of, robot.joints[i], place);
    }
  }
  std::vector<std::optional<ResolvedMimic>> resolved = direct;
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    std::size_t steps = 0;
    while (resolved[i] && direct[resolved[i]->source]) {
      // m1 (m2 q + o2) + o1
      const ResolvedMimic& next = *direct[resolved[i]->source];
      resolved[i]->offset += resolved[i]->multiplier * next.offset;
      resolved[i]->multiplier *= next.multiplier;
      resolved[i]->source = next.source;
      if (++steps > robot.joints.size()) {
        place.within("joint " + quoted(robot.joints[i].joint.name))
            .addError(robot.joints[i].line, "mimic that leads in a circle",
                      "mimic of a joint that has its own position");
        resolved[i].reset();
      }
    }
  }
  return resolved;
}

}  // namespace collision_monitor
