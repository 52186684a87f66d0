// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of all links against a chain of transforms built straight from urdfdom's
// model by recursion, in Eigen's quaternions and isometries: another reader, another
// order of links, another representation of rotations.
#include "collision_monitor/model/kinematics.h"

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

constexpr unsigned kSeed = 20240717;

using PositionsByName = std::map<std::string, std::vector<double>>;

Eigen::Isometry3d motionOf(const urdf::Joint& joint, const PositionsByName& positions) {
  const Eigen::Vector3d axis =
      Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
  const auto valueOf = [&](const urdf::Joint& one) {
    return one.mimic
               ? one.mimic->multiplier * positions.at(one.mimic->joint_name)[0] + one.mimic->offset
               : positions.at(one.name)[0];
  };
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      motion.rotate(Eigen::Quaterniond(Eigen::AngleAxisd(valueOf(joint), axis)));
      break;
    case urdf::Joint::PRISMATIC:
      motion.translate(valueOf(joint) * axis);
      break;
    case urdf::Joint::FLOATING: {
      const auto& q = positions.at(joint.name);
      motion.translate(Eigen::Vector3d(q[0], q[1], q[2]));
      motion.rotate(Eigen::Quaterniond(q[6], q[3], q[4], q[5]).normalized());
      break;
    }
    case urdf::Joint::PLANAR: {
      const auto& q = positions.at(joint.name);
      motion.translate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis) *
                       Eigen::Vector3d(q[0], q[1], 0.0));
      motion.rotate(Eigen::Quaterniond(Eigen::AngleAxisd(q[2], axis)));
      break;
    }
    default:
      break;
  }
  return motion;
}

void placeChildren(const urdf::Link& link, const Eigen::Isometry3d& world_from_link,
                   const PositionsByName& positions,
                   std::map<std::string, Eigen::Isometry3d>& world_from) {
  world_from[link.name] = world_from_link;
  for (const auto& joint : link.child_joints) {
    const urdf::Pose& origin = joint->parent_to_joint_origin_transform;
    Eigen::Isometry3d parent_from_joint = Eigen::Isometry3d::Identity();
    parent_from_joint.translate(
        Eigen::Vector3d(origin.position.x, origin.position.y, origin.position.z));
    parent_from_joint.rotate(Eigen::Quaterniond(origin.rotation.w, origin.rotation.x,
                                                origin.rotation.y, origin.rotation.z));
    for (const auto& child : link.child_links) {
      if (child->name == joint->child_link_name) {
        placeChildren(*child, world_from_link * parent_from_joint * motionOf(*joint, positions),
                      positions, world_from);
      }
    }
  }
}

/// Variables of one joint, inside its limits where it has them.
std::vector<double> randomVariables(const Joint& joint, std::mt19937& random) {
  const double lower = std::max(joint.lower, -3.0);
  const double upper = std::min(joint.upper, 3.0);
  std::uniform_real_distribution<double> within(lower, std::nextafter(upper, 4.0));
  switch (joint.type) {
    case JointType::fixed:
      return {};
    case JointType::planar:
      return {within(random), within(random), within(random)};
    case JointType::floating:
      return {within(random), within(random), within(random), within(random),
              within(random), within(random), within(random)};
    default:
      return {within(random)};
  }
}

TEST(KinematicsAgreement, everyRobot_isPlacedAsUrdfdomsTreeSays) {
  std::mt19937 random(kSeed);
  std::size_t robot_count = 0;
  double worst = 0.0;
  for (const test::RobotFile& file : test::allRobotFiles()) {
    SCOPED_TRACE(file.name);
    const RobotDescription description = test::describe(file);
    const urdf::ModelInterfaceSharedPtr theirs = urdf::parseURDF(description.urdf_xml);
    SetupReport report;
    const RobotModel ours = readRobots({description}, test::oneTriangleLoader(), report);
    if (!theirs || !report.errors.empty()) {
      continue;
    }
    ++robot_count;
    for (int round = 0; round < 20; ++round) {
      JointPositions positions(ours.variable_count);
      PositionsByName by_name;
      for (const Joint& joint : ours.joints) {
        if (!joint.mimic) {
          by_name[joint.name] = randomVariables(joint, random);
          std::copy(by_name[joint.name].begin(), by_name[joint.name].end(),
                    positions.begin() + static_cast<std::ptrdiff_t>(joint.first_variable));
        }
      }
      std::vector<Pose> world_from_link;
      placeLinks(ours, positions, {Pose{}}, world_from_link);
      std::map<std::string, Eigen::Isometry3d> world_from;
      placeChildren(*theirs->getRoot(), Eigen::Isometry3d::Identity(), by_name, world_from);
      for (std::size_t i = 0; i < ours.links.size(); ++i) {
        const Eigen::Isometry3d& expected = world_from.at(ours.links[i].name);
        worst = std::max({worst, (world_from_link[i].translation - expected.translation()).norm(),
                          (world_from_link[i].rotation - expected.linear()).cwiseAbs().maxCoeff()});
      }
    }
  }
  EXPECT_GT(robot_count, 0u) << "no robot was compared";
  EXPECT_LT(worst, 1e-12) << "seed " << kSeed;
  std::cout << robot_count << " robots, worst deviation " << worst << " m\n";
}

}  // namespace
}  // namespace collision_monitor
