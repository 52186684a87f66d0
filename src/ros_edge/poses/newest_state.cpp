// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/newest_state.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

constexpr double kWholeTurn = 2.0 * kPi;

/// An angle is within half a turn of 0.
double positionOf(const Joint& joint, const Pose& parent_from_child) {
  const Pose motion = inverse(joint.parent_from_joint) * parent_from_child;
  if (joint.type == JointType::prismatic) {
    return joint.axis.dot(motion.translation);
  }
  const Eigen::Matrix3d& r = motion.rotation;
  const Eigen::Vector3d doubled_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(joint.axis.dot(doubled_sine), r.trace() - 1.0);
}

/// Whether a whole turn of a joint leaves every link in place, including links that mimic it.
bool endsWhereItBegan(const RobotModel& model, JointId joint) {
  return model.joint(joint).type == JointType::continuous &&
         std::all_of(model.joints.begin(), model.joints.end(), [&](const Joint& other) {
           const bool follows = other.mimic && other.mimic->source == joint;
           return !follows || (other.type != JointType::prismatic &&
                               std::remainder(other.mimic->multiplier, 1.0) == 0.0);
         });
}

/// The only angle within the limits, modulo whole turns; nothing if there are several.
std::optional<double> withinLimits(const Joint& joint, double angle) {
  const double middle = 0.5 * (joint.lower + joint.upper);
  const double from_middle = std::remainder(angle - middle, kWholeTurn);
  // If the limits are infinite, the right side is infinite too.
  const bool is_only_one = kWholeTurn - std::abs(from_middle) > 0.5 * (joint.upper - joint.lower);
  return is_only_one ? std::optional(middle + from_middle) : std::nullopt;
}

}  // namespace

NewestState makeNewestState(const RobotModel& model) {
  return {makeLinkPoses(model),
          JointPositions(model.variable_count, std::numeric_limits<double>::quiet_NaN()),
          std::vector<std::string>(model.links.size())};
}

std::optional<double> newestPosition(const RobotModel& model, const NewestState& newest,
                                     JointId joint, double target) {
  const Joint& one = model.joint(joint);
  const double told = newest.positions[one.first_variable];
  const bool is_told = std::isfinite(told);
  if (!is_told && !isJoined(newest.poses, one.parent, one.child)) {
    return std::nullopt;
  }
  const auto& world_from_link = newest.poses.world_from_link;
  const double position = is_told ? told
                                  : positionOf(one, inverse(world_from_link[index(one.parent)]) *
                                                        world_from_link[index(one.child)]);
  if (endsWhereItBegan(model, joint)) {
    return target + std::remainder(position - target, kWholeTurn);
  }
  return is_told || one.type == JointType::prismatic ? position : withinLimits(one, position);
}

}  // namespace collision_monitor
