// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/constants.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor {
namespace {

using test::handMadeSetup;
using test::kEighthTurn;
using test::knownPoses;

void rest(LinkPoses& poses) {
  std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 1);
}

/// One cycle with a combined run; everything rests, and the reach is 0.2 m. The second link stands
/// at `translation`, and both are turned by `rotation`.
CycleCounters runTwo(const Shape& shape, const Eigen::Vector3d& translation,
                     const Eigen::Matrix3d& rotation) {
  const CycleSetup setup = handMadeSetup({{0, shape}, {1, shape}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::combination);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[0].rotation = rotation;
  poses.world_from_link[1] = {rotation, translation};
  rest(poses);
  runCycle(setup, poses, buffers);
  return buffers.counters;
}

TEST(CullCandidates, ballsAcrossACorner_spheresPart) {
  // 0.35 m along two axes: boxes of 0.2 m half edge meet, the balls are 0.295 m apart.
  const CycleCounters counters =
      runTwo(Sphere{0.1}, {0.35, 0.35, 0.0}, Eigen::Matrix3d::Identity());
  EXPECT_EQ(counters.candidates, 1U);
  EXPECT_EQ(counters.culled_by_spheres, 1U);
  EXPECT_EQ(counters.culled_by_boxes, 0U);
}

TEST(CullCandidates, longBoxesSideBySideAtAnAngle_orientedBoxesPart) {
  // Along their common short axis the boxes are 0.5 m - 2 * 0.05 m = 0.4 m apart.
  const CycleCounters counters =
      runTwo(Box{{1.0, 0.05, 0.05}}, kEighthTurn * Eigen::Vector3d(0.0, 0.5, 0.0), kEighthTurn);
  EXPECT_EQ(counters.candidates, 1U);
  EXPECT_EQ(counters.culled_by_spheres, 0U);
  EXPECT_EQ(counters.culled_by_boxes, 1U);
}

TEST(CullCandidates, withinReach_stays) {
  for (const Shape& shape : {Shape(Box{{1.0, 0.05, 0.05}}),
                             Shape(RoundedBox{{0.5, 0.0, 0.02}, 0.05}), Shape(Sphere{0.05})}) {
    const CycleCounters counters =
        runTwo(shape, kEighthTurn * Eigen::Vector3d(0.0, 0.299, 0.0), kEighthTurn);
    EXPECT_EQ(counters.candidates, 1U);
    EXPECT_EQ(counters.culled_by_spheres + counters.culled_by_boxes, 0U);
    EXPECT_EQ(counters.measured, 1U);
  }
}

TEST(CullCandidates, everyRun_spheresPartWhatRests_andKeepWhatMayCome) {
  const CycleSetup setup = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[1].translation = {0.35, 0.35, 0.0};  // 0.295 m apart
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.counters.culled_by_spheres, 1U) << "nobody knows how they move";
  rest(poses);
  resetMemory(buffers);  // and with it their distance
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.counters.culled_by_spheres, 1U);
  poses.velocities.of_link[1].linear.z() = 1.0;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.counters.culled_by_spheres, 0U) << "0.5 m within the horizon of 0.5 s";
}

/// Two balls of 0.1 m, each 0.3 m beside its link's origin; horizon 0.5 s, reach 0.2 m, hysteresis
/// 0.005 m, stop at 0.01 m.
class FindReachesTest : public testing::Test {
 protected:
  FindReachesTest() { rest(poses_); }
  double reach() {
    runCycle(setup_, poses_, buffers_);
    return buffers_.activation.of(0);
  }
  Twist& twist(std::size_t link) { return poses_.velocities.of_link[link]; }

  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}, {Eigen::Matrix3d::Identity(), {0.3, 0, 0}}},
                                     {1, Sphere{0.1}, {Eigen::Matrix3d::Identity(), {0.3, 0, 0}}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(FindReachesTest, nothingMoves_orAllMovesAlike) {
  EXPECT_NEAR(reach(), 0.2, 1e-12);
  twist(0) = twist(1) = {{3.0, 0, 0}, {0, 0, 1.0}};
  EXPECT_NEAR(reach(), 0.2, 1e-12);
}

TEST_F(FindReachesTest, oneMovesOrTurns_howFarItGetsWithinTheHorizon) {
  twist(1).linear.y() = 2.0;
  EXPECT_NEAR(reach(), 0.015 + 1.0, 1e-9);
  // 2 rad/s: the ball's center goes at 0.6 m/s, its surface 0.2 m/s faster.
  twist(1) = {Eigen::Vector3d::Zero(), {0, 0, 2.0}};
  EXPECT_NEAR(reach(), 0.015 + 0.4, 1e-9);
}

TEST_F(FindReachesTest, velocityNotKnownOrNotANumber_noTimeFollows) {
  twist(1).linear.y() = 2.0;
  twist(0).angular.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(reach(), 0.2, 1e-12);
  twist(0).angular.x() = 0.0;
  EXPECT_GT(reach(), 1.0);
  poses_.velocities.known[1] = 0;
  EXPECT_NEAR(reach(), 0.2, 1e-12);
}

TEST_F(FindReachesTest, continuous_theWaySinceTheLastCycleCounts) {
  setup_.is_continuous = true;
  poses_.stamp_ns = 1000000000;
  EXPECT_NEAR(reach(), 0.2, 1e-12);
  poses_.world_from_link[0].translation.x() = 0.25;
  poses_.world_from_link[1].translation.z() = 1.5;
  poses_.stamp_ns += 10000000;
  EXPECT_NEAR(reach(), 0.25 + 1.5, 1e-9);
}

TEST(CullCandidates, metOnTheWay_stays) {
  // A ball flies past another in one cycle, from 1 m on one side to 1 m on the other.
  CycleSetup setup = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  setup.is_continuous = true;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::combination);
  LinkPoses poses = knownPoses(setup);
  poses.stamp_ns = 1000000000;
  poses.world_from_link[1].translation.x() = -1.0;
  runCycle(setup, poses, buffers);
  poses.stamp_ns += 10000000;
  poses.world_from_link[1].translation.x() = 1.0;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.distances.passed.size(), 1U);
}

}  // namespace
}  // namespace collision_monitor
