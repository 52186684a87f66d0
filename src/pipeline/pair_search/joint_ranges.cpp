// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/joint_ranges.h"

#include <Eigen/Core>
#include <cmath>

namespace collision_monitor {
namespace {

constexpr double kHalfTurn = 3.141592653589793;
constexpr double kMetre = 1.0;

/// Draws from -1 to 1. Distributions of standard libraries differ from each other.
double drawUnit(std::mt19937_64& random) {
  constexpr int kDigits = 53;
  return std::ldexp(static_cast<double>(random() >> (64 - kDigits)), 1 - kDigits) - 1.0;
}

void drawFree(const Joint& joint, std::mt19937_64& random, JointPositions& state) {
  double* const variables = state.data() + joint.first_variable;
  variables[0] = kMetre * drawUnit(random);
  variables[1] = kMetre * drawUnit(random);
  if (joint.type == JointType::planar) {
    variables[2] = kHalfTurn * drawUnit(random);
    return;
  }
  variables[2] = kMetre * drawUnit(random);
  // Uniform rotations: points of the cube that lie within the ball.
  Eigen::Map<Eigen::Vector4d> quaternion(variables + 3);
  do {
    for (double& number : quaternion) {
      number = drawUnit(random);
    }
  } while (quaternion.squaredNorm() > 1.0 || quaternion.squaredNorm() < 1e-4);
  quaternion.normalize();
}

}  // namespace

std::vector<JointRange> jointRanges(const RobotModel& model) {
  std::vector<JointRange> ranges;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.mimic || freedomOf(joint) != 1) {
      continue;
    }
    const double reach = joint.type == JointType::prismatic ? kMetre : kHalfTurn;
    const bool has_lower = std::isfinite(joint.lower);
    const bool has_upper = std::isfinite(joint.upper);
    // A missing limit lies `reach` from 0, or from the other limit if that excludes 0.
    const double lower =
        has_lower ? joint.lower : -reach + (has_upper ? std::min(0.0, joint.upper) : 0.0);
    const double upper =
        has_upper ? joint.upper : reach + (has_lower ? std::max(0.0, joint.lower) : 0.0);
    ranges.push_back({idAt<JointId>(i), lower, upper,
                      (has_lower && has_upper) || joint.type == JointType::continuous});
  }
  return ranges;
}

JointPositions drawState(const RobotModel& model, const std::vector<JointRange>& ranges,
                         std::mt19937_64& random) {
  JointPositions state = defaultPositions(model);
  for (const JointRange& range : ranges) {
    const double share = 0.5 + 0.5 * drawUnit(random);
    state[model.joint(range.joint).first_variable] =
        range.lower + share * (range.upper - range.lower);
  }
  for (const Joint& joint : model.joints) {
    if (!joint.mimic && freedomOf(joint) > 1) {
      drawFree(joint, random, state);
    }
  }
  return state;
}

}  // namespace collision_monitor
