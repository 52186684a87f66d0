// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/kinematics/plane_axes.h"
#include "model/kinematics/state_kinematics.h"

namespace collision_monitor {
namespace {

/// Joints that do not move about or along an axis keep their frame.
Eigen::Matrix3d frameFromAxis(const Joint& joint) {
  return joint.type == JointType::floating ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                           : rotationFromZTo(joint.axis);
}

/// Adds the frame that `joint` moves. Returns the pose of its child link in that frame.
LinkPlace addFrame(const Joint& joint, const LinkPlace& parent, KinematicsPlan& plan) {
  const Eigen::Matrix3d turned = frameFromAxis(joint);
  MovingFrame frame;
  frame.type = joint.type;
  frame.parent = parent.frame;
  frame.first_variable = joint.first_variable;
  if (joint.mimic) {
    frame.multiplier = joint.mimic->multiplier;
    frame.offset = joint.mimic->offset;
  }
  frame.parent_from_frame =
      parent.frame_from_link * joint.parent_from_joint * Pose{turned, Eigen::Vector3d::Zero()};
  plan.frames.push_back(frame);
  return {static_cast<std::uint32_t>(plan.frames.size() - 1),
          Pose{turned.transpose(), Eigen::Vector3d::Zero()}};
}

}  // namespace

Pose poseOf(const StatePose& pose, std::size_t state) noexcept {
  Pose one;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    one.translation[row] = pose.translation[k].of[state];
    one.rotation.row(row) << pose.axis_x[k].of[state], pose.axis_y[k].of[state],
        pose.axis_z[k].of[state];
  }
  return one;
}

StandingPoses standingAt(const RobotModel& model, const std::vector<Pose>& world_from_root) {
  StandingPoses standing{world_from_root, {}};
  standing.held.resize(model.joints.size());
  return standing;
}

KinematicsPlan planKinematics(const RobotModel& model, const StandingPoses& standing) {
  KinematicsPlan plan;
  plan.variable_count = model.variable_count;
  for (const Link& link : model.links) {
    LinkPlace place;
    if (!link.parent_joint) {
      place.frame_from_link = standing.world_from_root[index(link.robot)];
    } else {
      const Joint& joint = model.joint(*link.parent_joint);
      const std::optional<Pose>& held = standing.held[index(*link.parent_joint)];
      const LinkPlace parent = plan.links[index(joint.parent)];
      const bool is_fixed = held || joint.type == JointType::fixed;
      place = is_fixed ? LinkPlace{parent.frame,
                                   parent.frame_from_link * held.value_or(joint.parent_from_joint)}
                       : addFrame(joint, parent, plan);
    }
    plan.links.push_back(place);
  }
  return plan;
}

}  // namespace collision_monitor
