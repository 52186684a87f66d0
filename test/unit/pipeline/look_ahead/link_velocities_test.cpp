// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/link_velocities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_monitor/model/kinematics.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::jointXml;
using test::robotXml;

/// base -(turn, about z)- arm -(fixed, 1 m along x)- hand -(slide, along x)- tip,
/// and a finger on the arm that follows the slide along z, twice as far.
const std::string kArm = robotXml(
    "<link name='base'/><link name='arm'/><link name='hand'/><link name='tip'/>"
    "<link name='finger'/>" +
    jointXml("turn", "continuous", "base", "arm", "<axis xyz='0 0 1'/>") +
    jointXml("wrist", "fixed", "arm", "hand", "<origin xyz='1 0 0'/>") +
    jointXml("slide", "prismatic", "hand", "tip",
             "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/>") +
    jointXml("follow", "prismatic", "arm", "finger",
             "<axis xyz='0 0 1'/><limit lower='-9' upper='9'/>"
             "<mimic joint='slide' multiplier='2'/>"));

class LinkVelocitiesTest : public testing::Test {
 protected:
  void placeLinksOf(double turn, double slide) {
    JointPositions positions(model_.variable_count, 0.0);
    positions[variable("turn")] = turn;
    positions[variable("slide")] = slide;
    placeLinks(model_, positions, {Pose()}, poses_.world_from_link);
  }
  void placeAt(double seconds, double turn, double slide) {
    placeLinksOf(turn, slide);
    std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
    poses_.robot_stamp_ns[0] = static_cast<std::int64_t>(1e9 * seconds);
    trackVelocities(model_, options_, tracker_, poses_);
  }
  std::size_t variable(const char* joint) const {
    return model_.joint(*model_.findJoint(joint)).first_variable;
  }
  std::size_t link(const char* name) const { return index(*model_.findLink(name)); }
  bool isKnown(const char* name) const { return poses_.velocities.known[link(name)] != 0; }
  Vector3d velocityOf(const char* name) const {
    return velocityAt(poses_.velocities.of_link[link(name)],
                      poses_.world_from_link[link(name)].translation);
  }

  RobotModel model_ = test::readText(kArm).model;
  VelocityOptions options_{0.0, 0.5};
  VelocityTracker tracker_ = makeVelocityTracker(model_);
  LinkPoses poses_ = makeLinkPoses(model_);
};

TEST_F(LinkVelocitiesTest, twoStamps_tellTheVelocity) {
  placeAt(1.0, 0.0, 0.0);
  EXPECT_FALSE(isKnown("hand")) << "one stamp tells nothing";
  placeAt(1.1, 0.2, 0.0);
  ASSERT_TRUE(isKnown("hand"));
  // 2 rad/s at a lever of 1 m, at the angle 0.2.
  const Vector3d expected(-2 * std::sin(0.2), 2 * std::cos(0.2), 0);
  EXPECT_LT((velocityOf("hand") - expected).norm(), 1e-9);
  EXPECT_LT(velocityOf("base").norm(), 1e-12);
}

TEST_F(LinkVelocitiesTest, sameStamp_keepsTheVelocity) {
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.0, 0.3);
  placeAt(1.1, 0.0, 0.3);
  ASSERT_TRUE(isKnown("tip"));
  EXPECT_NEAR(velocityOf("tip").x(), 3.0, 1e-9);
}

TEST_F(LinkVelocitiesTest, filter_followsAStep) {
  options_.time_constant = 0.1;
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.0, 0.0);
  placeAt(1.2, 0.0, 0.1);
  EXPECT_NEAR(velocityOf("tip").x(), 1.0 - std::exp(-1.0), 1e-6);
}

TEST_F(LinkVelocitiesTest, gapAndJumpBack_makeItUnknownUntilTwoStampsMore) {
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.0, 0.1);
  placeAt(1.7, 0.0, 0.2);
  EXPECT_FALSE(isKnown("tip")) << "0.6 s are more than the longest gap";
  placeAt(1.8, 0.0, 0.3);
  EXPECT_TRUE(isKnown("tip"));
  placeAt(0.5, 0.0, 0.0);
  EXPECT_FALSE(isKnown("tip"));
  placeAt(0.6, 0.0, 0.0);
  EXPECT_TRUE(isKnown("tip"));
  resetTracker(tracker_);
  placeAt(0.7, 0.0, 0.0);
  EXPECT_FALSE(isKnown("tip"));
}

TEST_F(LinkVelocitiesTest, linkThatIsNotKnown_hasNoVelocity) {
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.0, 0.0);
  poses_.status[link("tip")] = LinkStatus::stale;
  trackVelocities(model_, options_, tracker_, poses_);
  EXPECT_FALSE(isKnown("tip"));
  EXPECT_TRUE(isKnown("hand"));
  poses_.world_from_link[link("hand")].translation.x() = std::numeric_limits<double>::quiet_NaN();
  poses_.robot_stamp_ns[0] += 100'000'000;
  trackVelocities(model_, options_, tracker_, poses_);
  EXPECT_FALSE(isKnown("hand"));
}

TEST_F(LinkVelocitiesTest, jointVelocities_goBeforeStamps) {
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.0, 0.0);
  JointVelocities velocities(model_.variable_count, 0.0);
  velocities[variable("turn")] = 2.0;
  velocities[variable("slide")] = 0.5;
  applyJointVelocities(model_, velocities, poses_);
  EXPECT_LT((velocityOf("hand") - Vector3d(0, 2, 0)).norm(), 1e-12);
  EXPECT_LT((velocityOf("tip") - Vector3d(0.5, 2, 0)).norm(), 1e-12);
  EXPECT_LT((velocityOf("finger") - Vector3d(0, 0, 1)).norm(), 1e-12) << "on the axis, mimic";
}

TEST_F(LinkVelocitiesTest, jointThatSaysNothing_leavesWhatStampsTold) {
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.2, 0.0);
  JointVelocities velocities(model_.variable_count, std::numeric_limits<double>::quiet_NaN());
  velocities[variable("slide")] = 0.5;
  applyJointVelocities(model_, velocities, poses_);
  EXPECT_NEAR(velocityOf("hand").norm(), 2.0, 1e-9);
  const Vector3d along(std::cos(0.2), std::sin(0.2), 0);
  EXPECT_NEAR(velocityOf("tip").dot(along), 0.5, 1e-9) << "on top of what the hand does";
}

TEST_F(LinkVelocitiesTest, jointVelocitiesOfARootThatIsNotKnown_tellNothing) {
  placeAt(1.0, 0.0, 0.0);
  applyJointVelocities(model_, JointVelocities(model_.variable_count, 1.0), poses_);
  EXPECT_FALSE(isKnown("tip"));
}

/// The arm and what is on it float, as seen from the arm.
void floatArm(std::size_t arm, LinkPoses& poses) {
  const Pose arm_from_world = inverse(poses.world_from_link[arm]);
  for (std::size_t link = arm; link < poses.part.size(); ++link) {
    poses.world_from_link[link] = arm_from_world * poses.world_from_link[link];
    poses.part[link] = static_cast<PartId>(arm);
    poses.part_status[link] = LinkStatus::stale;
  }
}

TEST_F(LinkVelocitiesTest, partThatFloats_movesAsSeenFromItsTop) {
  options_.longest_gap = 10.0;
  placeAt(1.0, 0.0, 0.0);
  placeAt(1.1, 0.2, 0.1);
  ASSERT_TRUE(isKnown("hand"));
  floatArm(link("arm"), poses_);
  trackVelocities(model_, options_, tracker_, poses_);
  EXPECT_TRUE(isKnown("arm")) << "the top rests";
  EXPECT_EQ(velocityOf("arm").norm(), 0.0);
  EXPECT_FALSE(isKnown("hand")) << "what is known of it is as seen from the world, and no new "
                                   "stamp has come";
  EXPECT_TRUE(isKnown("base"));
  for (const double seconds : {1.2, 1.3}) {
    placeLinksOf(0.2, 10.0 * (seconds - 1.2));
    floatArm(link("arm"), poses_);
    poses_.robot_stamp_ns[0] = static_cast<std::int64_t>(1e9 * seconds);
    trackVelocities(model_, options_, tracker_, poses_);
    EXPECT_EQ(isKnown("tip"), seconds > 1.25) << "two stamps in one part";
  }
  EXPECT_NEAR(velocityOf("tip").x(), 10.0, 1e-9);
  EXPECT_NEAR(velocityOf("tip").y(), 0.0, 1e-9);
}

TEST_F(LinkVelocitiesTest, jointsOfAPartThatFloats_tellAtOnce) {
  placeAt(0.9, 0.5, 0.25);
  placeAt(1.0, 0.5, 0.25);
  ASSERT_TRUE(isKnown("base"));
  floatArm(link("arm"), poses_);
  trackVelocities(model_, options_, tracker_, poses_);
  JointVelocities velocities(model_.variable_count, 0.0);
  velocities[variable("turn")] = 3.0;
  velocities[variable("slide")] = 2.0;
  applyJointVelocities(model_, velocities, poses_);
  ASSERT_TRUE(isKnown("tip"));
  EXPECT_LT((velocityOf("tip") - Vector3d(2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((velocityOf("finger") - Vector3d(0, 0, 4)).norm(), 1e-12);
  EXPECT_EQ(velocityOf("arm").norm(), 0.0) << "nobody knows what the part hangs on";
}

}  // namespace
}  // namespace collision_monitor
