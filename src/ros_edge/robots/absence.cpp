// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/absence.h"

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

/// Unknown beside the link before it: it begins a part of its own, or has no pose at all.
bool isLost(const LinkPoses& poses, LinkId link) {
  return poses.status[index(link)] != LinkStatus::known || poses.part[index(link)] == index(link);
}

}  // namespace

bool isAbsent(const RobotModel& model, RobotId robot, const LinkPoses& poses) {
  const Robot& of = model.robots[index(robot)];
  bool is_moving = false;
  for (std::size_t i = of.first_joint; i < of.first_joint + of.joint_count; ++i) {
    const Joint& joint = model.joints[i];
    if (joint.type != JointType::fixed) {
      is_moving = true;
      if (!isLost(poses, joint.child)) {
        return false;
      }
    }
  }
  return is_moving || isLost(poses, of.root);
}

}  // namespace collision_monitor
