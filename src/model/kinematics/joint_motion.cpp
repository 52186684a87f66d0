// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/kinematics.h"
#include "model/kinematics/plane_axes.h"

namespace collision_monitor {
namespace {

/// Velocities of the child at its own origin, for a unit of the k-th velocity.
/// Frames: the joint frame.
struct UnitMotion {
  Eigen::Vector3d velocity{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular{Eigen::Vector3d::Zero()};
};

Eigen::Vector3d unitVector(std::size_t k) noexcept {
  return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k));
}

UnitMotion unitMotion(const Joint& joint, std::size_t k) noexcept {
  UnitMotion motion;
  switch (joint.type) {
    case JointType::fixed:
      break;
    case JointType::revolute:
    case JointType::continuous:
      motion.angular = joint.axis;
      break;
    case JointType::prismatic:
      motion.velocity = joint.axis;
      break;
    case JointType::planar:
      if (k < 2) {
        motion.velocity = rotationFromZTo(joint.axis) * unitVector(k);
      } else {
        motion.angular = joint.axis;
      }
      break;
    case JointType::floating:
      (k < 3 ? motion.velocity : motion.angular) = unitVector(k % 3);
      break;
  }
  return motion;
}

std::vector<const char*> endingsOf(JointType type) {
  switch (type) {
    case JointType::fixed:
      return {};
    case JointType::planar:
      return {"/x", "/y", "/theta"};
    case JointType::floating:
      return {"/trans_x", "/trans_y", "/trans_z", "/turn_x", "/turn_y", "/turn_z"};
    default:
      return {""};
  }
}

}  // namespace

std::size_t freedomOf(const Joint& joint) noexcept {
  switch (joint.type) {
    case JointType::fixed:
      return 0;
    case JointType::planar:
      return 3;
    case JointType::floating:
      return 6;
    default:
      return 1;
  }
}

Twist jointTwist(const Joint& joint, std::size_t k, const Pose& world_from_parent,
                 const Pose& world_from_child) noexcept {
  const Eigen::Matrix3d world_from_joint =
      world_from_parent.rotation * joint.parent_from_joint.rotation;
  const UnitMotion unit = unitMotion(joint, k);
  const double factor = joint.mimic ? joint.mimic->multiplier : 1.0;
  return factor * twistAbout(world_from_child.translation, world_from_joint * unit.velocity,
                             world_from_joint * unit.angular);
}

std::vector<std::string> velocityNames(const RobotModel& model) {
  std::vector<std::string> names(model.variable_count);
  for (const Joint& joint : model.joints) {
    if (joint.mimic) {
      continue;
    }
    std::size_t variable = joint.first_variable;
    for (const char* ending : endingsOf(joint.type)) {
      names[variable++] = joint.name + ending;
    }
  }
  return names;
}

}  // namespace collision_monitor
