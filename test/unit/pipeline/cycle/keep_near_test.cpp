// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/keep_near.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

/// A ball, and on another link two, 0.05 m farther away the second.
class TwoParts : public testing::Test {
 protected:
  TwoParts() { prepare(); }
  void prepare() {
    buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
  }
  std::vector<double> distancesAt(double gap) {
    poses_.world_from_link[1].translation.x() = 0.2 + gap;
    runCycle(setup_, poses_, buffers_);
    std::vector<double> distances;
    for (const PairDistance& distance : buffers_.distances.pairs) {
      distances.push_back(std::round(1e6 * distance.measured.distance) / 1e6);
    }
    return distances;
  }

  CycleSetup setup_ =
      handMadeSetup({{0, Sphere{0.1}},
                     {1, Sphere{0.1}},
                     {1, Sphere{0.1}, {Eigen::Matrix3d::Identity(), {0.05, 0.0, 0.0}}}});
  CycleBuffers buffers_;
  LinkPoses poses_ = knownPoses(setup_);
};

/// As TwoParts, but both stand for one element.
class OneElement : public TwoParts {
 protected:
  OneElement() {
    setup_.element_pair_of[1] = setup_.element_pair_of[0];
    setup_.bodies[2].element = setup_.bodies[1].element;
    prepare();
  }
};

TEST_F(TwoParts, nearEnoughToBeWarnedOf_nearestBodiesAlone) {
  EXPECT_EQ(distancesAt(0.002), std::vector<double>{0.002});
}

TEST_F(TwoParts, nearEnoughToStop_allBodies) {
  setup_.ahead.stop.stop_distance = 0.06;
  prepare();
  EXPECT_EQ(distancesAt(0.002), (std::vector<double>{0.002, 0.052}));
  EXPECT_EQ(distancesAt(0.003), (std::vector<double>{0.003, 0.053}));
}

TEST_F(TwoParts, velocityNotKnown_nearestBodiesAlone) {
  poses_.velocities.known[0] = 0;
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1});
  EXPECT_EQ(buffers_.counters.measured, 2U);
  EXPECT_EQ(distancesAt(0.11), std::vector<double>{0.11});
  EXPECT_EQ(buffers_.counters.measured, 1U);
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact));
}

TEST_F(TwoParts, firstCycleAfterLearning_measuresNearestBodiesAlone) {
  poses_.velocities.known[0] = 0;
  poses_.world_from_link[1].translation.x() = 0.3;
  learnPairs(setup_, poses_, buffers_);
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1});
  EXPECT_EQ(buffers_.counters.measured, 1U);
}

TEST_F(OneElement, firstCycleAfterLearning_measuresNearestBodiesAlone) {
  poses_.world_from_link[1].translation.x() = 0.3;
  learnPairs(setup_, poses_, buffers_);
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1});
  EXPECT_EQ(buffers_.counters.measured, 1U);
}

TEST_F(OneElement, turnedOrMovedAfterLearning_measuresWhatHasComeNear) {
  poses_.world_from_link[1].translation.x() = 0.6;
  learnPairs(setup_, poses_, buffers_);
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1});
  prepare();
  poses_.world_from_link[1].translation.x() = 0.3;
  learnPairs(setup_, poses_, buffers_);
  const double half_turn = std::acos(-1.0);
  poses_.world_from_link[1].rotation =
      Eigen::AngleAxisd(half_turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.05}) << "the other body is nearest now";
}

/// A ball at rest is nearer than two of a link whose velocity is not known.
TEST(PartsThatStop, fartherThanTheyWarn_keepTheSpeedScaleWhileNobodyListens) {
  const Pose farther{Eigen::Matrix3d::Identity(), {0.05, 0.0, 0.0}};
  CycleSetup setup = handMadeSetup(
      {{0, Sphere{0.1}}, {1, Sphere{0.1}}, {1, Sphere{0.1}, farther}, {2, Sphere{0.1}}});
  setup.ahead.stop.stop_distance = 0.15;
  setup.refine.distance = 0.0;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  buffers.refine.tells_all = false;
  LinkPoses poses = knownPoses(setup);
  poses.velocities.known = {1, 0, 1};
  poses.world_from_link[1].translation.x() = 0.3;
  poses.world_from_link[2].translation.x() = -0.22;
  for (int cycle = 0; cycle < 6; ++cycle) {
    poses.stamp_ns += 1'000'000'000;
    runCycle(setup, poses, buffers);
    EXPECT_EQ(buffers.memory.speed.scale, 0.0) << cycle;
  }
}

/// Two links of two parts each: the nearest parts, and 200 m along y two that are 4 cm apart.
class PartsThatTurn : public testing::TestWithParam<bool> {
 protected:
  PartsThatTurn() {
    buffers_.refine.tells_all = GetParam();
    poses_.world_from_link[1].translation.x() = 0.23;
    poses_.velocities.known = {1, 1};
  }
  /// The velocities of the second link's parts along x: the scale after a cycle 1 ms later.
  double scaleAfter(double of_nearest, double of_other) {
    poses_.stamp_ns += 1'000'000;
    poses_.velocities.of_link[1].linear.x() = of_nearest;
    poses_.velocities.of_link[1].angular.z() = (of_nearest - of_other) / 200.0;
    runCycle(setup_, poses_, buffers_);
    sought_ += buffers_.robots.seeks_closing ? 1 : 0;
    return buffers_.memory.speed.scale;
  }
  /// As scaleAfter, but by a little more.
  double stepOfScale(double of_nearest, double of_other) {
    const double before = buffers_.memory.speed.scale;
    return scaleAfter(of_nearest, of_other) - before;
  }

  static Pose at(double x, double y) { return {Eigen::Matrix3d::Identity(), {x, y, 0.0}}; }
  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}},
                                     {0, Sphere{0.1}, at(0.0, 200.0)},
                                     {1, Sphere{0.1}},
                                     {1, Sphere{0.1}, at(0.01, 200.0)}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
  int sought_{0};  ///< cycles that looked at all parts that may close
};

TEST_P(PartsThatTurn, whileAFartherPartCloses_scaleGrowsSlowlyAndItAloneIsWatched) {
  const double slowed = scaleAfter(-0.5, -0.5);
  ASSERT_LT(slowed, 0.5);
  for (int cycle = 0; cycle < 20; ++cycle) {
    EXPECT_LT(stepOfScale(0.1, -0.002), 0.01) << cycle;
  }
  EXPECT_EQ(sought_, 1);
  scaleAfter(0.1, 0.1);
  EXPECT_EQ(scaleAfter(0.1, 0.1), 1.0) << "one cycle later: then all are known to part";
}

TEST_P(PartsThatTurn, whileAFartherPartRestsNear_scaleGrowsSlowly) {
  scaleAfter(-0.5, -0.5);
  for (int cycle = 0; cycle < 20; ++cycle) {
    EXPECT_LT(stepOfScale(0.1, 0.0), 0.01) << cycle;
  }
}

INSTANTIATE_TEST_SUITE_P(ToldOrNot, PartsThatTurn, testing::Bool());

/// One link turns about a part that stays near the other link; its far part passes that link's.
TEST(PartsThatPass, whileVelocitiesAreNotKnown_wereInContact) {
  const Pose far{Eigen::Matrix3d::Identity(), {0.0, 2.0, 0.0}};
  CycleSetup setup = handMadeSetup(
      {{0, Sphere{0.1}}, {0, Sphere{0.1}, far}, {1, Sphere{0.1}}, {1, Sphere{0.1}, far}});
  setup.is_continuous = true;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[1].translation.x() = 0.25;
  for (int cycle = 0; cycle < 6; ++cycle) {
    const double angle = cycle % 2 == 0 ? -0.1 : 0.35;
    poses.stamp_ns += 10'000'000;
    poses.world_from_link[1].rotation =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    runCycle(setup, poses, buffers);
    EXPECT_EQ(buffers.events.passed[0] != kNone, cycle > 0) << cycle;
    EXPECT_NEAR(buffers.distances.pairs[0].measured.distance, 0.05, 1e-9);
  }
}

TEST_F(OneElement, fartherThanWarnings_nearestBodiesAlone) {
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1});
  EXPECT_EQ(distancesAt(0.11), std::vector<double>{0.11});
}

TEST_F(OneElement, nearEnoughToBeWarnedOf_allBodies) {
  EXPECT_EQ(distancesAt(0.002), (std::vector<double>{0.002, 0.052}));
}

TEST_F(OneElement, thatMayTouchWithinTheHorizon_allBodies) {
  poses_.velocities.of_link[1].linear.x() = -1.0;
  EXPECT_EQ(distancesAt(0.1), (std::vector<double>{0.1, 0.15})) << "0.5 m in 0.5 s";
  poses_.velocities.of_link[1].linear.x() = -0.2;
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1}) << "0.115 m";
}

TEST_F(OneElement, velocityNotKnown_nearestBodiesAlone) {
  poses_.velocities.known[0] = 0;
  EXPECT_EQ(distancesAt(0.1), std::vector<double>{0.1}) << "they ask for the lowest scale";
  EXPECT_EQ(distancesAt(0.002), (std::vector<double>{0.002, 0.052}));
}

TEST_F(OneElement, whatIsNotKept_isRememberedAllTheSame) {
  distancesAt(0.1);
  const DistanceCache& cache = buffers_.memory.distance_cache;
  EXPECT_NEAR(cache.distances[0], 0.1, 1e-6);
  EXPECT_NEAR(cache.distances[1], 0.15, 1e-6) << "its body is not kept";
  EXPECT_NEAR(cache.nearest[0], 0.1, 1e-12);
  EXPECT_EQ(cache.measured_pairs, std::vector<ElementPairIndex>{0});
}

}  // namespace
}  // namespace collision_monitor::test
