// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/robot_model.h"
#include "support/random_poses.h"

namespace collision_monitor::test {

/// A joint of any type from an earlier link to `child`, sometimes a mimic joint.
inline Joint randomJoint(std::size_t child, Random& random, RobotModel& model) {
  constexpr JointType kTypes[] = {JointType::fixed,     JointType::revolute, JointType::continuous,
                                  JointType::prismatic, JointType::planar,   JointType::floating};
  Joint joint;
  joint.type = kTypes[random() % 6];
  joint.child = idAt<LinkId>(child);
  joint.parent = idAt<LinkId>(random() % child);
  joint.parent_from_joint = randomPose(random, 1.0);
  joint.axis = random() % 4 == 0 ? Eigen::Vector3d(0, 0, random() % 2 == 0 ? 1.0 : -1.0)
                                 : randomPoint(random, 1.0).normalized();
  joint.first_variable = model.variable_count;
  const bool has_one = joint.type == JointType::revolute || joint.type == JointType::continuous ||
                       joint.type == JointType::prismatic;
  if (has_one && random() % 4 == 0 && model.variable_count > 0) {
    joint.first_variable = random() % model.variable_count;
    joint.mimic = Mimic{JointId{0}, -1.5, 0.25};
  } else {
    model.variable_count += has_one                             ? 1
                            : joint.type == JointType::planar   ? 3
                            : joint.type == JointType::floating ? 7
                                                                : 0;
  }
  return joint;
}

/// One robot: a random tree of random joints.
inline RobotModel randomModel(std::size_t links, Random& random) {
  RobotModel model;
  model.robots.push_back({"robot", "", LinkId{0}, 0, links, 0, links - 1});
  model.links.resize(links);
  for (std::size_t child = 1; child < links; ++child) {
    model.links[child].parent_joint = idAt<JointId>(child - 1);
    model.joints.push_back(randomJoint(child, random, model));
  }
  return model;
}

}  // namespace collision_monitor::test
