// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/list_near.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor {
namespace {

using test::handMadeSetup;
using test::knownPoses;

/// Balls of 0.1 m: the second 0.3 m from the first along x, the third always the nearest. All rest
/// as far as velocities say; 0.2 m are reported.
class ListNear : public testing::Test {
 protected:
  ListNear() {
    poses_.world_from_link[1].translation.x() = 0.5;
    poses_.world_from_link[2].translation.y() = 0.3;
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
    run();
    run();  // distances are known now
  }
  void run() { runCycle(setup_, poses_, buffers_); }
  void move(double travel) {
    poses_.world_from_link[1].translation.x() += travel;
    run();
  }
  /// Of the first two balls.
  bool isListed() const {
    const auto& listed = buffers_.memory.distance_cache.listed;
    return std::count_if(listed.begin(), listed.end(),
                         [&](const ListedPair& one) { return one.pair == pair(); }) == 1;
  }
  bool isTold() const {
    const auto& told = buffers_.distances.pairs;
    return std::any_of(told.begin(), told.end(),
                       [&](const PairDistance& distance) { return distance.pair == pair(); });
  }
  PairId pair() const {
    PairId pair{kNone};
    setup_.table.find(BodyId{0}, BodyId{1}, pair);
    return pair;
  }

  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(ListNear, pairThatComesNearInSmallSteps_isToldInTime) {
  ASSERT_FALSE(isListed());
  for (int step = 0; step < 150; ++step) {
    move(-0.00101);
    EXPECT_EQ(isTold(), poses_.world_from_link[1].translation.x() <= 0.4) << step;
  }
  EXPECT_TRUE(isTold());
}

TEST_F(ListNear, pairThatJumps_isTold) {
  move(-0.2);
  EXPECT_TRUE(isTold());
}

TEST_F(ListNear, boundsAreNotLookedAt_untilTravelUsesUpTheMargin) {
  buffers_.bounds.boxes[1].min.setZero();
  move(0.4 * kListMargin);
  EXPECT_EQ(buffers_.bounds.boxes[1].min.norm(), 0.0);
  move(0.2 * kListMargin);
  EXPECT_GT(buffers_.bounds.boxes[1].min.norm(), 0.0);
}

TEST_F(ListNear, fasterMotionAhead_usesUpTheMargin) {
  poses_.velocities.of_link[1].linear.x() = -1.0;  // 0.5 m within the horizon
  run();
  EXPECT_TRUE(isListed());
  EXPECT_TRUE(isTold()) << "it touches within the horizon";
}

TEST_F(ListNear, whereMotionIsUnknown_boundsAreLookedAtInEachCycle) {
  poses_.velocities.known[1] = 0;
  run();
  buffers_.bounds.boxes[1].min.setZero();
  run();
  EXPECT_GT(buffers_.bounds.boxes[1].min.norm(), 0.0);
}

TEST_F(ListNear, whereMotionIsFast_thereIsNoList) {
  move(kListMargin);
  EXPECT_FALSE(buffers_.memory.distance_cache.is_listed) << "it would serve for no cycle";
  run();
  EXPECT_TRUE(buffers_.memory.distance_cache.is_listed);
}

TEST_F(ListNear, linkThatIsLost_leavesTheList) {
  move(-0.15);
  run();
  ASSERT_TRUE(isListed());
  poses_.status[1] = LinkStatus::stale;
  run();
  EXPECT_EQ(buffers_.candidates.size(), 1U) << "of the other two balls";
}

}  // namespace
}  // namespace collision_monitor
