// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/kinematics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "model/kinematics/plane_axes.h"

namespace collision_monitor {
namespace {

Pose rotationAbout(const Eigen::Vector3d& axis, double angle) noexcept {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Eigen::Vector3d::Zero()};
}

Pose translationBy(const Eigen::Vector3d& translation) noexcept {
  return {Eigen::Matrix3d::Identity(), translation};
}

Pose planarMotion(const Eigen::Vector3d& axis, const double* variables) noexcept {
  const Eigen::Vector3d in_plane(variables[0], variables[1], 0.0);
  return translationBy(rotationFromZTo(axis) * in_plane) * rotationAbout(axis, variables[2]);
}

Pose floatingMotion(const double* variables) noexcept {
  const Eigen::Vector4d xyzw(variables[3], variables[4], variables[5], variables[6]);
  // stableNorm of zeros is 0, so the division gives NaN: a zero quaternion is not a rotation.
  const Eigen::Vector4d unit = xyzw / xyzw.stableNorm();
  const Eigen::Quaterniond rotation(unit[3], unit[0], unit[1], unit[2]);
  return {rotation.toRotationMatrix(), {variables[0], variables[1], variables[2]}};
}

double positionOf(const Joint& joint, const JointPositions& positions) noexcept {
  const double own = positions[joint.first_variable];
  return joint.mimic ? joint.mimic->multiplier * own + joint.mimic->offset : own;
}

}  // namespace

/// Source: Rodrigues' formula with sin and cos taken from z x axis and z . axis. Where the axis
/// points towards -z, 1 + cos would cancel; sin^2 / (1 - cos) replaces it there.
Eigen::Matrix3d rotationFromZTo(const Eigen::Vector3d& axis) noexcept {
  const double x = axis.x();
  const double y = axis.y();
  const double cosine = axis.z();
  const double sine_squared = x * x + y * y;
  if (cosine < 0.0 && sine_squared < std::numeric_limits<double>::min()) {
    // The axis is -z: every turn axis in the plane is equally good. This one keeps x.
    return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  }
  const double k = cosine < 0.0 ? (1.0 - cosine) / sine_squared : 1.0 / (1.0 + cosine);
  Eigen::Matrix3d rotation;
  rotation << 1.0 - k * x * x, -k * x * y, x, -k * x * y, 1.0 - k * y * y, y, -x, -y, cosine;
  return rotation;
}

JointPositions defaultPositions(const RobotModel& model) {
  JointPositions positions(model.variable_count, 0.0);
  for (const Joint& joint : model.joints) {
    if (joint.mimic) {
      continue;
    }
    if (joint.type == JointType::floating) {
      positions[joint.first_variable + 6] = 1.0;
    } else if (joint.type == JointType::revolute || joint.type == JointType::prismatic) {
      positions[joint.first_variable] = std::clamp(0.0, joint.lower, joint.upper);
    }
  }
  return positions;
}

Pose parentFromChild(const Joint& joint, const JointPositions& positions) noexcept {
  switch (joint.type) {
    case JointType::fixed:
      break;
    case JointType::revolute:
    case JointType::continuous:
      return joint.parent_from_joint * rotationAbout(joint.axis, positionOf(joint, positions));
    case JointType::prismatic:
      return joint.parent_from_joint * translationBy(positionOf(joint, positions) * joint.axis);
    case JointType::planar:
      return joint.parent_from_joint *
             planarMotion(joint.axis, positions.data() + joint.first_variable);
    case JointType::floating:
      return joint.parent_from_joint * floatingMotion(positions.data() + joint.first_variable);
  }
  return joint.parent_from_joint;
}

void placeLinks(const RobotModel& model, const JointPositions& positions,
                const std::vector<Pose>& world_from_root, std::vector<Pose>& world_from_link) {
  world_from_link.resize(model.links.size());
  for (const Robot& robot : model.robots) {
    world_from_link[index(robot.root)] = world_from_root[index(model.link(robot.root).robot)];
  }
  // Parents come before their children, so one pass finds every parent placed.
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (const auto parent_joint = model.links[i].parent_joint) {
      const Joint& joint = model.joint(*parent_joint);
      world_from_link[i] = world_from_link[index(joint.parent)] * parentFromChild(joint, positions);
    }
  }
}

std::vector<Pose> defaultPoses(const RobotModel& model) {
  std::vector<Pose> world_from_link(model.links.size());
  placeLinks(model, defaultPositions(model), std::vector<Pose>(model.robots.size()),
             world_from_link);
  return world_from_link;
}

}  // namespace collision_monitor
