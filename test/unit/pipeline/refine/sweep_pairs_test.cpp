// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/sweep_pairs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/constants.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

/// Cycles 20 ms apart.
struct Scene {
  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;

  explicit Scene(CycleSetup made, bool is_continuous = true) : setup(std::move(made)) {
    setup.is_continuous = is_continuous;
    buffers = makeBuffers(setup, BroadPhaseKind::sweep_and_prune);
    poses = knownPoses(setup);
    poses.stamp_ns = 1'000'000'000;
  }
  Pose& link(std::size_t i) { return poses.world_from_link[i]; }
  void run() {
    runCycle(setup, poses, buffers);
    poses.stamp_ns += 20'000'000;
  }
  Verdict verdict() const { return buffers.events.verdicts[0]; }
  const std::vector<PassedContact>& passed() const { return buffers.distances.passed; }
};

/// A plate 2 mm thick across x at the origin, and a ball of radius 1 cm on its left.
Scene plateAndBall(const Limits& limits = Limits(), bool is_continuous = true) {
  Scene scene(handMadeSetup({{0, Box{{0.001, 0.3, 0.3}}}, {1, Sphere{0.01}}}, limits),
              is_continuous);
  scene.link(1).translation = {-0.091, 0.1, 0.0};
  scene.run();
  return scene;
}

TEST(SweepPairs, ballPassesAPlate_contactInThatCycleAtItsTime) {
  Scene scene = plateAndBall();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
  scene.link(1).translation.x() = 0.229;  // 16 m/s
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_EQ(scene.buffers.events.overall, Verdict::contact);
  ASSERT_EQ(scene.passed().size(), 1U);
  const PassedContact& contact = scene.passed()[0];
  EXPECT_NEAR(contact.time, 0.25, 1e-9);  // 0.08 m of 0.32 m
  EXPECT_EQ(contact.distance.quality, Quality::exact);
  EXPECT_TRUE(contact.distance.measured.point_on_a.isApprox(Eigen::Vector3d(-0.001, 0.1, 0), 1e-9));
  EXPECT_NEAR(contact.world_from_link_b.translation.x(), -0.011, 1e-9);
  EXPECT_EQ(contact.world_from_link_a.translation.norm(), 0.0);
  EXPECT_EQ(scene.buffers.events.passed[0], 0U);
  ASSERT_EQ(scene.buffers.events.changes.size(), 1U);
  EXPECT_EQ(scene.buffers.events.changes[0].after, Verdict::contact);
}

TEST(SweepPairs, nextCycle_isClearAgain) {
  Scene scene = plateAndBall();
  scene.link(1).translation.x() = 0.229;
  scene.run();
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
  EXPECT_TRUE(scene.passed().empty());
  EXPECT_EQ(scene.buffers.counters.swept, 0U);
}

TEST(SweepPairs, passesBeside_isClear) {
  Scene scene = plateAndBall();
  scene.link(1).translation = {-0.091, 0.0, 0.311};
  scene.run();
  scene.link(1).translation.x() = 0.229;
  scene.run();
  EXPECT_EQ(scene.buffers.counters.swept, 1U);
  EXPECT_TRUE(scene.passed().empty());
}

TEST(SweepPairs, switchedOff_seesNothing) {
  Scene scene = plateAndBall(Limits(), false);
  scene.link(1).translation.x() = 0.229;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
}

TEST(SweepPairs, afterAResetOrAGapInTheData_nothingIsJoined) {
  Scene scene = plateAndBall();
  resetMemory(scene.buffers);
  scene.link(1).translation.x() = 0.229;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
  scene.poses.status[1] = LinkStatus::stale;
  scene.run();
  scene.poses.status[1] = LinkStatus::known;
  scene.link(1).translation.x() = -0.091;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::clear);
  scene.link(1).translation.x() = 0.229;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
}

TEST(SweepPairs, inContactNow_isToldOnceAsThat) {
  Scene scene = plateAndBall();
  scene.link(1).translation.x() = 0.0;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_TRUE(scene.passed().empty());
  scene.link(1).translation.x() = 0.229;
  scene.run();
  EXPECT_TRUE(scene.passed().empty()) << "it left the contact that was told";
}

TEST(SweepPairs, contactDistance_countsOnTheWay) {
  Limits limits;
  limits.contact_distance = 0.02;
  Scene scene = plateAndBall(limits);
  scene.link(1).translation = {-0.1, 0.0, 0.325};  // 15 mm above the edge when it passes
  scene.run();
  scene.link(1).translation.x() = 0.1;
  scene.run();
  ASSERT_EQ(scene.passed().size(), 1U);
  EXPECT_NEAR(scene.passed()[0].distance.measured.distance, 0.02, 2e-7);
}

TEST(SweepPairs, rodTurnsThroughABall_isFoundOnItsArc) {
  // Half a turn about the origin by a rod from x = 0.2 to 0.4; the ball on the y axis.
  const Pose along_x{Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitY()).toRotationMatrix(),
                     {0.3, 0.0, 0.0}};
  Scene scene(handMadeSetup({{0, Capsule{0.1, 0.01}, along_x}, {1, Sphere{0.01}}}));
  scene.link(1).translation = {0.0, 0.3, 0.0};
  scene.run();
  scene.link(0).rotation =
      Eigen::AngleAxisd(0.9 * kPi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  scene.run();
  ASSERT_EQ(scene.passed().size(), 1U);
  EXPECT_NEAR(scene.passed()[0].time, (0.5 * kPi - std::asin(0.02 / 0.3)) / (0.9 * kPi), 1e-6);
}

TEST(SweepPairs, stepLimit_switchedOff_isBothThicknessesOverTheSpeedAtEachOther) {
  Scene scene = plateAndBall(Limits(), false);
  const StepLimit& step = scene.buffers.sweep.step;
  EXPECT_EQ(step.step, 0.0);
  scene.link(0).translation.x() += 0.01;  // 0.5 m/s, and 1.5 m/s
  scene.link(1).translation.x() -= 0.03;
  scene.run();
  EXPECT_NEAR(step.step, 0.02, 1e-12);
  EXPECT_NEAR(step.at_poses.longest, (0.002 + 0.02) / 2.0, 1e-12);
  EXPECT_EQ(step.on_way.longest, step.at_poses.longest);
  EXPECT_EQ(step.at_poses.pair, 0U);
  EXPECT_TRUE(step.at_poses.is_exceeded && step.on_way.is_exceeded);
  scene.link(0).translation.x() += 0.5;
  scene.link(1).translation.x() += 0.5;
  scene.run();
  EXPECT_GT(step.at_poses.longest, 1e6) << "both go the same way";
  EXPECT_FALSE(step.at_poses.is_exceeded || step.on_way.is_exceeded);
}

TEST(SweepPairs, stepCap_isShownWhereTheLookAtTheWayCoversIt) {
  for (const bool is_continuous : {true, false}) {
    Scene scene = plateAndBall(Limits(), is_continuous);
    const StepLimit& step = scene.buffers.sweep.step;
    for (int i = 0; i < 3; ++i) {
      scene.link(1).translation.z() += 0.1;  // 5 m/s
      scene.run();
    }
    EXPECT_NEAR(step.at_poses.longest, 0.022 / 5.0, 1e-12);
    EXPECT_TRUE(step.at_poses.is_exceeded);
    EXPECT_EQ(step.on_way.is_exceeded, !is_continuous) << "an even way is looked at";
    for (int i = 0; i < 2; ++i) {
      scene.link(1).translation.z() += 0.01;  // 0.5 m/s
      scene.run();
    }
    EXPECT_NEAR(step.at_poses.longest, 0.022 / 0.5, 1e-12);
    EXPECT_FALSE(step.at_poses.is_exceeded || step.on_way.is_exceeded);
  }
}

TEST(SweepPairs, stepCap_isOfThePairThatNeedsPosesMostOften) {
  // Each comes at the plate, link 0, and the last two at each other: the ball of 1 cm at 1 m/s
  // needs 22 ms, that of 2 cm at 3 m/s 14 ms, and both 60 mm at 2 m/s 30 ms.
  Scene scene(handMadeSetup({{0, Box{{0.001, 0.3, 0.3}}}, {1, Sphere{0.01}}, {2, Sphere{0.02}}}));
  scene.run();
  scene.link(1).translation.x() += 0.02;
  scene.link(2).translation.x() += 0.06;
  scene.run();
  const StepCap& cap = scene.buffers.sweep.step.at_poses;
  EXPECT_NEAR(cap.longest, 0.042 / 3.0, 1e-12);
  EXPECT_EQ(index(scene.setup.checked[cap.pair].a), 0U);
  EXPECT_EQ(index(scene.setup.checked[cap.pair].b), 2U);
  EXPECT_TRUE(cap.is_exceeded);
}

TEST(SweepPairs, stepLimit_twoPointsDoNotCount) {
  // The ball of 0.1 m and a point are 0.1 m thick together.
  Scene scene(handMadeSetup({{0, Sphere{0.0}}, {0, Sphere{0.05}}, {1, Sphere{0.0}}}), false);
  scene.run();
  scene.link(0).translation.x() += 1.0;
  scene.run();
  EXPECT_NEAR(scene.buffers.sweep.step.at_poses.longest, 0.02 * 0.1, 1e-9);
}

TEST(SweepPairs, stepLimit_isWhereThePathMayBendByBothThicknesses) {
  Scene scene = plateAndBall();
  const StepCap& step = scene.buffers.sweep.step.on_way;
  const Pose turn{Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                  Eigen::Vector3d(0.05, 0.0, 0.0)};
  for (int i = 0; i < 3; ++i) {
    scene.link(1) = turn * scene.link(1);
    scene.run();
    EXPECT_GT(step.longest, 1e3) << "an even screw is looked at as it is";
  }
  scene.link(1) = turn * scene.link(1);
  scene.link(1).translation.x() += 0.32;
  scene.run();
  EXPECT_NEAR(step.longest, 0.02 * std::sqrt(0.022 / (0.32 / 8.0)), 1e-9);
  EXPECT_TRUE(step.is_exceeded);
  resetMemory(scene.buffers);
  scene.run();
  scene.link(1).translation.x() -= 0.32;
  scene.run();
  EXPECT_FALSE(step.is_exceeded) << "what was before is forgotten";
}

/// Two angles of bars 0.1 m thick (see geometry_setup.h), the second moved.
Scene angles(const RefineLimits& refine) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;  // one shape holds the hollow of the angle too
  options.refine.limits = refine;
  return Scene(geometrySetup({angleMesh(), Sphere{0.02}}, options));
}

TEST(SweepPairs, throughTheHollowOfAMesh_onlyItsShapeIsMet) {
  Scene scene = angles(RefineLimits());
  scene.link(1).translation = {0.2, 0.2, -0.2};  // beside both bars, within the shape
  scene.run();
  scene.link(1).translation.z() = 0.2;
  scene.run();
  EXPECT_EQ(scene.buffers.counters.swept, 1U);
  EXPECT_TRUE(scene.passed().empty());
  EXPECT_EQ(scene.verdict(), Verdict::clear);
}

TEST(SweepPairs, throughABarOfAMesh_isFoundOnTheMesh) {
  Scene scene = angles(RefineLimits());
  scene.link(1).translation = {0.2, 0.05, -0.2};
  scene.run();
  scene.link(1).translation.z() = 0.2;
  scene.run();
  ASSERT_EQ(scene.passed().size(), 1U);
  const PassedContact& contact = scene.passed()[0];
  EXPECT_TRUE(contact.distance.is_refined);
  EXPECT_EQ(contact.distance.quality, Quality::exact);
  EXPECT_NEAR(contact.time, (0.2 - 0.07) / 0.4, 1e-6);
  EXPECT_NEAR(contact.distance.measured.point_on_a.z(), -0.05, 1e-6);
}

TEST(SweepPairs, budgetSpent_aContactOfEnclosingShapes) {
  Scene scene = angles({0.05, 0});
  scene.link(1).translation = {0.2, 0.2, -0.2};
  scene.run();
  scene.link(1).translation.z() = 0.2;
  scene.run();
  ASSERT_EQ(scene.passed().size(), 1U);
  EXPECT_EQ(scene.passed()[0].distance.quality, Quality::lower_bound);
  EXPECT_EQ(scene.buffers.counters.swept_left, 1U);
  EXPECT_EQ(scene.verdict(), Verdict::contact);
}

TEST(SweepPairs, elementsFartherAtBothEndsThanTheWay_takeNoBudget) {
  for (const double height : {0.08, 0.15}) {
    Scene scene = angles(RefineLimits());
    scene.link(1).translation = {0.2, 0.2, -height};
    scene.run();
    scene.link(1).translation.z() = height;
    scene.run();
    EXPECT_EQ(scene.buffers.counters.swept, 1U);
    CycleBuffers& buffers = scene.buffers;
    buffers.refine.limits.budget = 0;  // then what is followed is left open
    sweepPairs(scene.setup, buffers.memory.refined, buffers.refine, buffers.sweep,
               buffers.distances);
    EXPECT_EQ(scene.passed().empty(), height < 0.1);
  }
}

}  // namespace
}  // namespace collision_monitor::test
