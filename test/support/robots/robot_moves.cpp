// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/robot_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pipeline/look_ahead/link_velocities.h"

namespace collision_monitor::test {

std::optional<RobotFile> findRobot(const std::string& name) {
  for (const RobotFile& robot : allRobotFiles()) {
    if (robot.name.find(name) != std::string::npos) {
      return robot;
    }
  }
  std::fprintf(stderr, "no robot '%s' among the shared data and urdf/\n", name.c_str());
  return std::nullopt;
}

bool isDrawn(const Joint& joint) {
  return !joint.mimic &&
         (joint.type == JointType::revolute || joint.type == JointType::continuous ||
          joint.type == JointType::prismatic);
}

JointPositions drawPositions(const RobotModel& model, std::mt19937_64& random) {
  JointPositions positions = defaultPositions(model);
  for (const Joint& joint : model.joints) {
    if (isDrawn(joint)) {
      const double reach = joint.type == JointType::prismatic ? 1.0 : 3.0;
      positions[joint.first_variable] = std::uniform_real_distribution<double>(
          std::max(joint.lower, -reach), std::min(joint.upper, reach))(random);
    }
  }
  return positions;
}

JointPositions between(const JointPositions& from, const JointPositions& to, double share) {
  JointPositions positions = from;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] += share * (to[i] - from[i]);
  }
  return positions;
}

LinkPoses posesAt(const RobotModel& model, const JointPositions& positions) {
  LinkPoses poses = makeLinkPoses(model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  placeLinks(model, positions, std::vector<Pose>(model.robots.size()), poses.world_from_link);
  return poses;
}

JointPath randomPath(const RobotModel& model) {
  constexpr std::size_t kWaypoints = 100;
  constexpr std::size_t kPartWaypoints = 25;
  JointPath path;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (isDrawn(model.joints[i])) {
      path.joints.push_back(idAt<JointId>(i));
    }
  }
  std::mt19937_64 random(20260101);
  JointPositions from = drawPositions(model, random);
  JointPositions to = drawPositions(model, random);
  for (std::size_t k = 0; k < kWaypoints; ++k) {
    path.times.push_back(0.1 * static_cast<double>(k));
    if (k > 0 && k % kPartWaypoints == 0) {
      from = to;
      to = drawPositions(model, random);
    }
    const double share = static_cast<double>(k % kPartWaypoints) / kPartWaypoints;
    const JointPositions positions = between(from, to, share);
    for (const JointId joint : path.joints) {
      path.positions.push_back(positions[model.joint(joint).first_variable]);
    }
  }
  return path;
}

Mover::Mover(const RobotModel& model, double rate, double speed)
    : model_(model), rate_(rate), speed_(speed) {}

std::vector<LinkPoses> Mover::next() {
  constexpr double kDuration = 0.5;  // [s]
  const JointPositions from = drawPositions(model_, random_);
  const JointPositions to = drawPositions(model_, random_);
  double farthest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    farthest = std::max(farthest, std::abs(to[i] - from[i]));
  }
  const double shares_a_second = farthest > 0.0 ? speed_ / farthest : 0.0;
  VelocityTracker tracker = makeVelocityTracker(model_);
  std::vector<LinkPoses> move;
  for (double time = 0.0; time < kDuration; time += 1.0 / rate_) {
    LinkPoses& poses =
        move.emplace_back(posesAt(model_, between(from, to, shares_a_second * time)));
    stamp_ns_ += static_cast<std::int64_t>(1e9 / rate_);
    poses.stamp_ns = stamp_ns_;
    std::fill(poses.robot_stamp_ns.begin(), poses.robot_stamp_ns.end(), stamp_ns_);
    trackVelocities(model_, {}, tracker, poses);
  }
  return move;
}

}  // namespace collision_monitor::test
