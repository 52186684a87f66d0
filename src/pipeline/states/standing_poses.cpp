// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <optional>

#include "pipeline/states/check_states.h"
#include "pipeline/states/float_unknown.h"

namespace collision_monitor {
namespace {

Pose unknownPose() {
  Pose pose;
  pose.translation.setConstant(std::numeric_limits<double>::quiet_NaN());
  return pose;
}

}  // namespace

StandingPoses standingAs(const RobotModel& model, const LinkPoses& poses,
                         const std::vector<bool>& moves) {
  StandingPoses standing;
  for (const Robot& robot : model.robots) {
    const bool is_placed = statusInWorld(poses, robot.root) == LinkStatus::known;
    standing.world_from_root.push_back(is_placed ? poses.world_from_link[index(robot.root)]
                                                 : unknownPose());
  }
  for (const Joint& joint : model.joints) {
    const bool is_fixed = joint.type == JointType::fixed;
    std::optional<Pose> held;
    if (is_fixed || !moves[joint.first_variable]) {
      if (isJoined(poses, joint.parent, joint.child)) {
        held = inverse(poses.world_from_link[index(joint.parent)]) *
               poses.world_from_link[index(joint.child)];
      } else if (!is_fixed) {
        held = unknownPose();
      }
    }
    standing.held.push_back(held);
  }
  return standing;
}

StandingPoses floatUnknown(const RobotModel& model, StandingPoses standing, LinkPoses& poses) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& joint = model.links[i].parent_joint;
    std::optional<Pose> held = standing.world_from_root[index(model.links[i].robot)];
    if (joint) {
      held = standing.held[index(*joint)];
      poses.part[i] = poses.part[index(model.joint(*joint).parent)];
    }
    if (!held || isFinite(*held)) {
      continue;
    }
    floatFrom(i, LinkStatus::missing, poses);
    if (joint) {
      standing.held[index(*joint)] = Pose();
    } else {
      standing.world_from_root[index(model.links[i].robot)] = Pose();
    }
  }
  return standing;
}

}  // namespace collision_monitor
