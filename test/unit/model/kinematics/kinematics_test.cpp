// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/kinematics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::readText;
using test::robotXml;

Joint offsetJoint(JointType type, const Eigen::Vector3d& axis) {
  Joint result;
  result.type = type;
  result.axis = axis;
  result.parent_from_joint.translation = {1.0, 2.0, 3.0};
  return result;
}

void expectNear(const Eigen::Vector3d& actual, const Eigen::Vector3d& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-14) << actual.transpose();
}

TEST(Kinematics, fixedJoint_isItsOrigin) {
  expectNear(
      parentFromChild(offsetJoint(JointType::fixed, Eigen::Vector3d::UnitX()), {}).translation,
      {1.0, 2.0, 3.0});
}

TEST(Kinematics, revoluteJoint_turnsAboutItsAxis) {
  const Pose pose =
      parentFromChild(offsetJoint(JointType::revolute, Eigen::Vector3d::UnitZ()), {kPi / 2.0});
  expectNear(pose * Eigen::Vector3d::UnitX(), {1.0, 3.0, 3.0});
}

TEST(Kinematics, origin_comesBeforeTheMotion) {
  Joint turned = offsetJoint(JointType::revolute, Eigen::Vector3d::UnitZ());
  // The joint's z is the parent's x, so x (parent's -z) goes to y (still y).
  turned.parent_from_joint.rotation =
      Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Pose pose = parentFromChild(turned, {kPi / 2.0});
  expectNear(pose * Eigen::Vector3d::UnitX(), {1.0, 3.0, 3.0});
  expectNear(pose * Eigen::Vector3d::UnitZ(), {2.0, 2.0, 3.0});
}

TEST(Kinematics, prismaticJoint_movesAlongItsAxis) {
  const Pose pose =
      parentFromChild(offsetJoint(JointType::prismatic, Eigen::Vector3d(0.0, 0.6, 0.8)), {5.0});
  expectNear(pose.translation, {1.0, 5.0, 7.0});
  EXPECT_EQ(pose.rotation, Eigen::Matrix3d::Identity());
}

TEST(Kinematics, planarJoint_movesInThePlaneAndTurnsAboutItsNormal) {
  const Pose about_z = parentFromChild(offsetJoint(JointType::planar, Eigen::Vector3d::UnitZ()),
                                       {0.1, 0.2, kPi / 2.0});
  expectNear(about_z.translation, {1.1, 2.2, 3.0});
  expectNear(about_z * Eigen::Vector3d::UnitX(), {1.1, 3.2, 3.0});
  // The least rotation from z to x turns about y: x of the plane is -z, y stays y.
  const Pose about_x =
      parentFromChild(offsetJoint(JointType::planar, Eigen::Vector3d::UnitX()), {0.1, 0.2, 0.0});
  expectNear(about_x.translation, {1.0, 2.2, 2.9});
  // Half a turn about x: y of the plane is -y.
  const Pose about_minus_z =
      parentFromChild(offsetJoint(JointType::planar, -Eigen::Vector3d::UnitZ()), {0.1, 0.2, 0.0});
  expectNear(about_minus_z.translation, {1.1, 1.8, 3.0});
}

TEST(Kinematics, floatingJoint_hasAPositionAndAQuaternion) {
  const double half = std::sqrt(0.5);
  const Pose pose = parentFromChild(offsetJoint(JointType::floating, Eigen::Vector3d::UnitX()),
                                    {0.1, 0.2, 0.3, 0.0, 0.0, half, half});
  expectNear(pose.translation, {1.1, 2.2, 3.3});
  expectNear(pose * Eigen::Vector3d::UnitX(), {1.1, 3.2, 3.3});
}

TEST(Kinematics, floatingJointWithLongQuaternion_isNormalised) {
  const Pose pose = parentFromChild(offsetJoint(JointType::floating, Eigen::Vector3d::UnitX()),
                                    {0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 3.0});
  EXPECT_TRUE(isRigid(pose, 1e-14));
}

TEST(Kinematics, floatingJointWithQuaternionOfZeros_isNotFinite) {
  EXPECT_FALSE(isFinite(parentFromChild(offsetJoint(JointType::floating, Eigen::Vector3d::UnitX()),
                                        {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0})));
}

TEST(Kinematics, positionThatIsNotFinite_givesAPoseThatIsNot) {
  for (const double position :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const JointType type :
         {JointType::revolute, JointType::continuous, JointType::prismatic}) {
      EXPECT_FALSE(isFinite(parentFromChild(offsetJoint(type, {0.0, 0.6, 0.8}), {position})));
    }
    EXPECT_FALSE(isFinite(parentFromChild(offsetJoint(JointType::planar, Eigen::Vector3d::UnitZ()),
                                          {0, position, 0})));
  }
}

TEST(Kinematics, mimicJoint_followsItsSource) {
  Joint follower = offsetJoint(JointType::prismatic, Eigen::Vector3d::UnitX());
  follower.mimic = Mimic{JointId{0}, -2.0, 0.5};
  expectNear(parentFromChild(follower, {0.1}).translation, {1.3, 2.0, 3.0});
}

/// base -(a, about z)- upper (1 m along x) -(b, about z)- lower (1 m along x)
const std::string kTwoJoints =
    robotXml("<link name='base'/><link name='upper'/><link name='lower'/>" +
             jointXml("a", "revolute", "base", "upper",
                      "<axis xyz='0 0 1'/><limit lower='0.5' upper='2'/><origin xyz='1 0 0'/>") +
             jointXml("b", "revolute", "upper", "lower",
                      "<axis xyz='0 0 1'/><limit lower='-2' upper='-1'/><origin xyz='1 0 0'/>"));

TEST(Kinematics, defaultPositions_areWithinTheLimits) {
  const RobotModel model = readText(kTwoJoints).model;
  EXPECT_EQ(defaultPositions(model), (JointPositions{0.5, -1.0}));
}

TEST(Kinematics, defaultPoses_areThoseOfTheDefaultPositions) {
  const std::vector<Pose> world_from_link = defaultPoses(readText(kTwoJoints).model);
  ASSERT_EQ(world_from_link.size(), 3U);
  expectNear(world_from_link[0].translation, {0, 0, 0});
  expectNear(world_from_link[1].translation, {1, 0, 0});
  expectNear(world_from_link[2].translation, {1 + std::cos(0.5), std::sin(0.5), 0});
  expectNear(world_from_link[2].rotation.col(0), {std::cos(-0.5), std::sin(-0.5), 0});
}

TEST(Kinematics, defaultOfFloatingJoint_isIdentity) {
  const RobotModel model =
      readText(robotXml("<link name='a'/><link name='b'/>" + jointXml("j", "floating", "a", "b")))
          .model;
  EXPECT_EQ(defaultPositions(model), (JointPositions{0, 0, 0, 0, 0, 0, 1}));
}

TEST(Kinematics, placeLinks_foldsAnArm) {
  const RobotModel model = readText(kTwoJoints).model;
  Pose world_from_root;
  world_from_root.translation = {0.0, 0.0, 5.0};
  std::vector<Pose> world_from_link;
  placeLinks(model, {kPi / 2.0, -kPi / 2.0}, {world_from_root}, world_from_link);
  ASSERT_EQ(world_from_link.size(), 3u);
  expectNear(world_from_link[0].translation, {0.0, 0.0, 5.0});
  expectNear(world_from_link[1].translation, {1.0, 0.0, 5.0});
  expectNear(world_from_link[2].translation, {1.0, 1.0, 5.0});
  expectNear(world_from_link[2] * Eigen::Vector3d::UnitX(), {2.0, 1.0, 5.0});
}

TEST(Kinematics, placeLinks_twoRobotsEachFromItsRoot) {
  RobotDescription left = test::describeText(kTwoJoints);
  RobotDescription right = left;
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  SetupReport report;
  const RobotModel model = readRobots({left, right}, test::textLoader({}), report);
  Pose right_root;
  right_root.translation = {0.0, 7.0, 0.0};
  std::vector<Pose> world_from_link;
  placeLinks(model, {0.0, 0.0, kPi / 2.0, 0.0}, {Pose{}, right_root}, world_from_link);
  expectNear(world_from_link[2].translation, {2.0, 0.0, 0.0});
  expectNear(world_from_link[5].translation, {1.0, 8.0, 0.0});
}

}  // namespace
}  // namespace collision_monitor
