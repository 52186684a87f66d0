// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/motion_bound.h"

#include <gtest/gtest.h>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/model/kinematics.h"
#include "support/robots/two_link_arm.h"

namespace collision_monitor::test {
namespace {

TEST(BoundMotion, turnsAndSlides_byTheirLeverArms) {
  const CycleSetup setup = armSetup();
  JointPath path;
  path.joints = {*setup.model.findJoint("shoulder"), *setup.model.findJoint("elbow")};
  const LinkId base = *setup.model.findLink("base");
  const LinkId hand = *setup.model.findLink("hand");
  const LinkChain chain = chainBetween(setup.model, path, base, hand);
  ASSERT_EQ(chain.joints.size(), 2U);
  std::vector<Pose> poses;
  placeLinks(setup.model, {0.0, 0.0}, {Pose()}, poses);
  const std::vector<Ball> balls = linkBalls(setup);
  EXPECT_NEAR(balls[index(hand)].center.x(), 1.0, 1e-12);
  EXPECT_NEAR(balls[index(hand)].radius, 0.1, 1e-12);
  JointLevers levers(balls, setup.model, path);
  levers.moveTo(poses);
  // The elbow moves the hand by 1.1 * 0.1; the shoulder turns the base, whose ball it passes
  // through, rather than the hand 2 m away.
  EXPECT_NEAR(boundMotion(chain, {0.2, 0.1}, levers), 0.11 + 0.02, 1e-12);
  // Either side may be taken; both joints on the hand's side would be 0.11 + 0.2 * 2.21.
  EXPECT_NEAR(boundMotion(chain, {0.2, 0.0}, levers), 0.02, 1e-12);
  // A quarter turn of the shoulder carries the elbow's axis along: the hand is as far from it. The
  // base is not.
  placeLinks(setup.model, {0.0, 1.5}, {Pose()}, poses);
  levers.moveTo(poses);
  EXPECT_NEAR(boundMotion(chain, {0.0, 0.1}, levers), 0.11, 1e-12);
  const LinkId post = *setup.model.findLink("post");
  EXPECT_TRUE(chainBetween(setup.model, path, base, post).joints.empty());
}

}  // namespace
}  // namespace collision_monitor::test
