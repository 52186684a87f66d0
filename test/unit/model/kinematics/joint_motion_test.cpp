// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "collision_monitor/model/kinematics.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::jointXml;
using test::robotXml;

/// The parent is turned so that its x is the world's y; the child is at (1, 2, 3).
const Pose kParent{Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitZ()).toRotationMatrix(),
                   Vector3d(9, 9, 9)};
const Pose kChild{Eigen::Matrix3d::Identity(), Vector3d(1, 2, 3)};

Joint joint(JointType type, const Vector3d& axis) {
  Joint result;
  result.type = type;
  result.axis = axis;
  return result;
}

void expectTwist(const Twist& twist, const Vector3d& of_child, const Vector3d& angular) {
  EXPECT_LT((velocityAt(twist, kChild.translation) - of_child).norm(), 1e-14);
  EXPECT_LT((twist.angular - angular).norm(), 1e-14);
}

TEST(JointMotion, revolute_turnsAboutItsAxisThroughTheChild) {
  const Joint turning = joint(JointType::revolute, Vector3d::UnitX());
  ASSERT_EQ(freedomOf(turning), 1U);
  expectTwist(jointTwist(turning, 0, kParent, kChild), Vector3d::Zero(), {0, 1, 0});
}

TEST(JointMotion, prismatic_movesAlongItsAxis) {
  const Joint sliding = joint(JointType::prismatic, Vector3d(0.6, 0.8, 0));
  expectTwist(jointTwist(sliding, 0, kParent, kChild), {-0.8, 0.6, 0}, Vector3d::Zero());
}

TEST(JointMotion, planar_movesInItsPlaneAndTurns) {
  const Joint planar = joint(JointType::planar, Vector3d::UnitZ());
  ASSERT_EQ(freedomOf(planar), 3U);
  expectTwist(jointTwist(planar, 0, kParent, kChild), {0, 1, 0}, Vector3d::Zero());
  expectTwist(jointTwist(planar, 1, kParent, kChild), {-1, 0, 0}, Vector3d::Zero());
  expectTwist(jointTwist(planar, 2, kParent, kChild), Vector3d::Zero(), {0, 0, 1});
}

TEST(JointMotion, floating_hasSixVelocities) {
  const Joint floating = joint(JointType::floating, Vector3d::UnitX());
  ASSERT_EQ(freedomOf(floating), 6U);
  expectTwist(jointTwist(floating, 1, kParent, kChild), {-1, 0, 0}, Vector3d::Zero());
  expectTwist(jointTwist(floating, 3, kParent, kChild), Vector3d::Zero(), {0, 1, 0});
}

TEST(JointMotion, mimic_movesByItsMultiplier) {
  Joint follower = joint(JointType::prismatic, Vector3d::UnitZ());
  follower.mimic = Mimic{JointId{0}, -2.0, 0.5};
  expectTwist(jointTwist(follower, 0, kParent, kChild), {0, 0, -2}, Vector3d::Zero());
}

TEST(JointMotion, fixed_doesNotMove) {
  EXPECT_EQ(freedomOf(joint(JointType::fixed, Vector3d::UnitX())), 0U);
}

TEST(VelocityNames, everyVelocityHasOne) {
  const std::string xml =
      "<link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
      "<link name='e'/>" +
      jointXml("turn", "continuous", "a", "b") +
      jointXml("drive", "planar", "b", "c", "<axis xyz='0 0 1'/>") +
      jointXml("fly", "floating", "c", "d") +
      jointXml("follow", "continuous", "d", "e", "<mimic joint='turn'/>");
  const std::vector<std::string> names = velocityNames(test::readText(robotXml(xml)).model);
  EXPECT_EQ(names, (std::vector<std::string>{"turn", "drive/x", "drive/y", "drive/theta",
                                             "fly/trans_x", "fly/trans_y", "fly/trans_z",
                                             "fly/turn_x", "fly/turn_y", "fly/turn_z", ""}));
}

}  // namespace
}  // namespace collision_monitor
