// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/measure_pairs.h"

#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/expect_distance.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// Shapes on links of their own, along x, and their distances.
struct MeasuredScene {
  explicit MeasuredScene(const std::vector<ShapeOnLink>& shapes)
      : setup(handMadeSetup(shapes)),
        buffers(makeBuffers(setup, BroadPhaseKind::brute_force)),
        poses(knownPoses(setup)) {}
  void placeAlongX(const std::vector<double>& x) {
    for (std::size_t link = 0; link < x.size(); ++link) {
      poses.world_from_link[link].translation.x() = x[link];
    }
    placeBodies(setup, poses, buffers.body_poses);
  }
  void measure(const std::vector<PairId>& pairs) {
    measurePairs(setup, buffers.body_poses, pairs, buffers.distances);
  }
  void findClosest(double reach) { measureClosest(setup, poses, reach, buffers); }
  const std::vector<PairDistance>& measured() const { return buffers.distances.pairs; }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
};

TEST(MeasurePairs, simplerCoreOnTheHigherLink_pointsAreThoseOfTheirBodies) {
  MeasuredScene scene({{0, Box{{0.1, 0.2, 0.3}}}, {1, Sphere{0.1}}});
  scene.placeAlongX({0.0, 0.5});
  scene.measure({PairId{0}});
  ASSERT_EQ(scene.measured().size(), 1U);
  EXPECT_EQ(scene.measured()[0].quality, Quality::exact);
  expectDistance(scene.measured()[0].measured, 0.3, Vector3d::UnitX(), {0.1, 0, 0});
}

TEST(MeasurePairs, bodyThatEnclosesMoreThanItself_isALowerBound) {
  MeasuredScene scene({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  scene.setup.bodies[1].is_exact = false;
  scene.placeAlongX({0.0, 0.5});
  scene.measure({PairId{0}});
  EXPECT_EQ(scene.measured()[0].quality, Quality::lower_bound);
}

/// 13 balls, 78 pairs: more than a batch of 64.
TEST(MeasurePairs, morePairsThanABatch_eachHasItsDistance) {
  std::vector<ShapeOnLink> balls;
  std::vector<double> x;
  for (std::size_t link = 0; link < 13; ++link) {
    balls.push_back({link, Sphere{0.1}});
    x.push_back(static_cast<double>(link * link));
  }
  MeasuredScene scene(balls);
  scene.placeAlongX(x);
  std::vector<PairId> all;
  for (std::uint32_t id = 0; id < 78; ++id) {
    all.push_back(PairId{id});
  }
  scene.measure(all);
  ASSERT_EQ(scene.measured().size(), 78U);
  for (std::uint32_t id = 0; id < 78; ++id) {
    const BodyPair& pair = scene.setup.table[PairId{id}];
    EXPECT_EQ(scene.measured()[id].pair, PairId{id});
    EXPECT_NEAR(scene.measured()[id].measured.distance, x[index(pair.b)] - x[index(pair.a)] - 0.2,
                kExact);
  }
}

TEST(MeasurePairs, addPairs_leavesWhatWasMeasured) {
  MeasuredScene scene({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  scene.placeAlongX({0.0, 1.0, 3.0});
  scene.measure({PairId{2}});
  addPairs(scene.setup, scene.buffers.body_poses, {PairId{0}}, scene.buffers.distances);
  ASSERT_EQ(scene.measured().size(), 2U);
  EXPECT_NEAR(scene.measured()[0].measured.distance, 1.8, kExact);
  EXPECT_NEAR(scene.measured()[1].measured.distance, 0.8, kExact);
}

TEST(MeasureClosest, nothingWithinReach_theClosestOfAllStandsAtItsPlace) {
  MeasuredScene scene({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  scene.placeAlongX({0.0, 9.0, 4.0});
  scene.measure({PairId{0}, PairId{2}});  // (0, 1) and (1, 2)
  scene.findClosest(0.2);
  ASSERT_EQ(scene.measured().size(), 3U);
  EXPECT_EQ(scene.measured()[1].pair, PairId{1});
  EXPECT_NEAR(scene.measured()[1].measured.distance, 3.8, kExact);
  scene.findClosest(0.2);
  EXPECT_EQ(scene.measured().size(), 3U) << "it is there already";
}

TEST(MeasureClosest, oneWithinReach_nothingIsSearched) {
  MeasuredScene scene({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  scene.placeAlongX({0.0, 0.35, 0.25});
  scene.measure({PairId{0}});
  scene.findClosest(0.2);
  EXPECT_EQ(scene.measured().size(), 1U) << "0.05 m are nearer, and 0.15 m near enough";
}

TEST(MeasureClosest, noPairIsKnown_thereIsNone) {
  MeasuredScene scene({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  scene.poses.status[1] = LinkStatus::missing;
  scene.placeAlongX({0.0, 0.5});
  scene.measure({});
  scene.findClosest(0.2);
  EXPECT_TRUE(scene.measured().empty());
}

}  // namespace
}  // namespace collision_monitor::test
