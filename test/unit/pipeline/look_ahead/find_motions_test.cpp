// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/find_motions.h"

#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/expect_distance.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// A ball on link 0, and on link 1 two, the second 0.3 m along x; stamps 10 ms apart.
class FindMotions : public testing::Test {
 protected:
  FindMotions() { poses_.stamp_ns = 1'000'000'000; }
  /// As a cycle does.
  void go() {
    placeBodies(setup_, poses_, buffers_.body_poses);
    findMotions(setup_, poses_, buffers_.body_poses, buffers_.memory, buffers_.sweep);
    keepPoses(poses_, buffers_.body_poses, buffers_.memory.last);
    poses_.stamp_ns += 10'000'000;
  }

  CycleSetup setup_ =
      handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {1, Sphere{0.1}, at(0.3, 0, 0)}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
  SweepWork& work_ = buffers_.sweep;
};

TEST_F(FindMotions, firstCycle_nothingCameBefore) {
  go();
  EXPECT_EQ(work_.has_motion, (std::vector<unsigned char>{0, 0}));
  EXPECT_EQ(work_.elapsed, 0.0);
}

TEST_F(FindMotions, linkThatMoved_isJoinedWithWhereItWas) {
  go();
  poses_.world_from_link[1].translation = {0, 0.4, 0};
  go();
  EXPECT_EQ(work_.has_motion, (std::vector<unsigned char>{1, 1}));
  EXPECT_NEAR(work_.elapsed, 0.01, 1e-15);
  expectNear(work_.link_motions[1].start.translation, Vector3d::Zero(), "start");
  expectNear(work_.link_motions[1].travel, {0, 0.4, 0}, "travel");
  EXPECT_EQ(work_.body_travel[0], 0.0);
  EXPECT_NEAR(work_.body_travel[1], 0.4, 1e-15);
}

TEST_F(FindMotions, linkThatTurned_carriesWhatIsFartherOutFarther) {
  go();
  poses_.world_from_link[1].rotation = kEighthTurn;
  go();
  const double angle = 0.25 * 3.14159265358979;
  EXPECT_NEAR(work_.body_travel[1], 0.1 * angle, 1e-12) << "its surface";
  EXPECT_NEAR(work_.body_travel[2], 0.4 * angle, 1e-12) << "0.3 m from the axis, and its surface";
  EXPECT_EQ(work_.element_travel[2], work_.body_travel[2]);
}

TEST_F(FindMotions, twoBodiesOfAnElement_theFartherWayIsTheElements) {
  setup_.bodies[2].element = setup_.bodies[1].element;
  go();
  poses_.world_from_link[1].rotation = kEighthTurn;
  go();
  EXPECT_EQ(work_.element_travel[1], work_.body_travel[2]);
  EXPECT_EQ(work_.element_travel[2], 0.0);
}

TEST_F(FindMotions, linkThatWasNotKnownOrElsewhere_hasNoWay) {
  go();
  poses_.status[1] = LinkStatus::stale;
  go();
  EXPECT_EQ(work_.has_motion[1], 0);
  poses_.status[1] = LinkStatus::known;
  poses_.world_from_link[1].translation.x() = 5.0;
  go();
  EXPECT_EQ(work_.has_motion[1], 0);
  EXPECT_EQ(work_.body_travel[1], 0.0);
  poses_.part = {1, 1};
  poses_.world_from_link[1].translation.x() = 0.0;
  go();
  EXPECT_EQ(work_.has_motion, (std::vector<unsigned char>{0, 0})) << "both in another part now";
}

TEST_F(FindMotions, sameStampAgain_isNoStepAndTheStepBeforeStays) {
  go();
  poses_.world_from_link[1].translation.x() = 0.4;
  go();
  poses_.world_from_link[1].translation.x() = 0.6;
  go();
  expectNear(work_.last_motions[1].travel, {0.4, 0, 0}, "of the step before");
  EXPECT_NEAR(work_.last_elapsed, 0.01, 1e-15);
  poses_.stamp_ns -= 10'000'000;
  go();
  EXPECT_EQ(work_.elapsed, 0.0);
  expectNear(work_.last_motions[1].travel, {0.2, 0, 0}, "of the step before");
}

TEST_F(FindMotions, posesForgotten_thereIsNoStepBefore) {
  go();
  go();
  go();
  EXPECT_GT(work_.last_elapsed, 0.0);
  forgetPoses(buffers_);
  go();
  EXPECT_EQ(work_.elapsed, 0.0);
  EXPECT_EQ(work_.last_elapsed, 0.0);
  EXPECT_EQ(work_.has_motion, (std::vector<unsigned char>{0, 0}));
}

}  // namespace
}  // namespace collision_monitor::test
