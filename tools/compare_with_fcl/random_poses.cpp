// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "random_poses.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double drawWithin(const Joint& joint, double reach, std::mt19937_64& random) {
  const double low = std::isfinite(joint.lower) ? joint.lower : std::min(-reach, joint.upper);
  const double high = std::isfinite(joint.upper) ? joint.upper : std::max(reach, joint.lower);
  return uniform(random, low, high);
}

void drawFloating(std::mt19937_64& random, double* variables) {
  std::normal_distribution<double> normal;
  Eigen::Vector4d quaternion;
  for (int i = 0; i < 3; ++i) {
    variables[i] = uniform(random, -1.0, 1.0);
  }
  for (Eigen::Index i = 0; i < 4; ++i) {
    quaternion[i] = normal(random);
  }
  Eigen::Map<Eigen::Vector4d>(variables + 3) = quaternion.normalized();
}

void drawJoint(const Joint& joint, std::mt19937_64& random, double* variables) {
  switch (joint.type) {
    case JointType::fixed:
      return;
    case JointType::floating:
      drawFloating(random, variables);
      return;
    case JointType::planar:
      variables[0] = uniform(random, -1.0, 1.0);
      variables[1] = uniform(random, -1.0, 1.0);
      variables[2] = uniform(random, -kHalfTurn, kHalfTurn);
      return;
    case JointType::continuous:
    case JointType::revolute:
      variables[0] = drawWithin(joint, kHalfTurn, random);
      return;
    case JointType::prismatic:
      variables[0] = drawWithin(joint, 1.0, random);
      return;
  }
}

JointPositions randomPositions(const RobotModel& model, std::mt19937_64& random) {
  JointPositions positions = defaultPositions(model);
  for (const Joint& joint : model.joints) {
    if (!joint.mimic) {
      drawJoint(joint, random, positions.data() + joint.first_variable);
    }
  }
  return positions;
}

}  // namespace

void forRandomPoses(const CycleSetup& setup, const ComparisonOptions& options,
                    const std::function<void(const LinkPoses&)>& use) {
  std::mt19937_64 random(options.seed);
  LinkPoses poses = makeLinkPoses(setup.model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  const std::vector<Pose> roots(setup.model.robots.size());
  for (std::size_t i = 0; i < options.poses; ++i) {
    placeLinks(setup.model, randomPositions(setup.model, random), roots, poses.world_from_link);
    use(poses);
  }
}

}  // namespace collision_monitor
