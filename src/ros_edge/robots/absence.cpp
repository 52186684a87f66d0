// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/absence.h"

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

bool isSilent(LinkStatus status) {
  return status == LinkStatus::missing || status == LinkStatus::stale;
}

/// Nobody tells how it stands to the link before it: it begins a part of its own, or has no pose.
bool isLost(const LinkPoses& poses, LinkId link) {
  const LinkStatus status = poses.status[index(link)];
  return status == LinkStatus::known ? poses.part[index(link)] == index(link) : isSilent(status);
}

/// Somebody tells of the link, but what cannot be used.
bool isFaulty(const LinkPoses& poses, std::size_t link) {
  const LinkStatus status = statusInWorld(poses, idAt<LinkId>(link));
  return status != LinkStatus::known && !isSilent(status);
}

}  // namespace

bool isAbsent(const RobotModel& model, RobotId robot, const LinkPoses& poses) {
  const Robot& of = model.robots[index(robot)];
  for (std::size_t i = of.first_link; i < of.first_link + of.link_count; ++i) {
    if (isFaulty(poses, i)) {
      return false;
    }
  }
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
