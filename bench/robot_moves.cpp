// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_moves.h"

#include <algorithm>
#include <cstdio>

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

JointPositions drawPositions(const RobotModel& model, std::mt19937_64& random) {
  JointPositions positions = defaultPositions(model);
  for (const Joint& joint : model.joints) {
    const bool moves = joint.type == JointType::revolute || joint.type == JointType::continuous ||
                       joint.type == JointType::prismatic;
    if (moves && !joint.mimic) {
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

}  // namespace collision_monitor::test
