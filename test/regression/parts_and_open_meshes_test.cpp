// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

// Bounds that are kept of distances were wrong in three ways. Into an open box, motion leads sooner
// than to its surface. Where nothing has moved, all of a measurement is recalled. And a link may
// turn while the set-up that takes over is prepared. So contacts and warnings were missed.
namespace collision_monitor::test::parts_and_open_meshes {
namespace {

using Links = std::vector<std::vector<CollisionElement>>;

CollisionElement partAt(const Geometry& geometry, const Eigen::Vector3d& place) {
  CollisionElement part;
  part.geometry = geometry;
  part.link_from_geometry.translation = place;
  return part;
}

/// A box of 1 m without its top, which is at height 0.
CollisionElement openBox() {
  return partAt(openBoxMesh(Eigen::Vector3d::Constant(0.5)), {0.0, 0.0, -0.5});
}

CycleSetup partsSetup(const Links& links, double padding) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.padding = padding;
  CycleSetup setup = linkSetup(links, options);
  setup.refine.budget = 100'000'000;
  setup.refine.distance = 0.1;
  setup.ahead.stop.release_time = 1e-9;
  return setup;
}

LinkPoses restingPoses(const CycleSetup& setup) {
  LinkPoses poses = knownPoses(setup);
  poses.velocities.known.assign(poses.velocities.known.size(), 1);
  poses.stamp_ns = 1'000'000'000;
  return poses;
}

const Geometry kTool = prismMesh(0.01, 0.01, 6);
const Geometry kBall = Sphere{0.02};

TEST(PartsAndOpenMeshes, whatSinksIntoAnOpenBoxWhileNobodyListens_isInContact) {
  const CycleSetup setup =
      partsSetup({{openBox()}, {partAt(kTool, {0, 0, 0})}, {partAt(kBall, {0, 0, 0})}}, 0.0);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  buffers.refine.tells_all = false;
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation.z() = -1.03;  // nearest of all, under the box
  for (int cycle = 0; cycle < 40; ++cycle) {
    poses.stamp_ns += 10'000'000;
    poses.world_from_link[1].translation.z() = 0.04 - 0.005 * cycle;
    runCycle(setup, poses, buffers);
  }
  EXPECT_EQ(buffers.events.verdicts[0], Verdict::contact);
}

TEST(PartsAndOpenMeshes, whatReturnsToItsLastMeasurementAndSinks_isInContact) {
  const CycleSetup setup =
      partsSetup({{openBox()}, {partAt(kTool, {0, 0, 0})}, {partAt(kBall, {0, 0, 0})}}, 0.01);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  buffers.refine.tells_all = false;
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation.z() = -1.05;  // nearest of all, under the box
  const double measured_at = 0.06;
  for (int cycle = 0; cycle < 60; ++cycle) {
    poses.stamp_ns += 10'000'000;
    double& height = poses.world_from_link[1].translation.z();
    height = cycle == 0 ? measured_at : cycle < 20 ? 0.5 : measured_at - 0.004 * (cycle - 20);
    runCycle(setup, poses, buffers);
  }
  EXPECT_EQ(buffers.events.verdicts[0], Verdict::contact);
}

TEST(PartsAndOpenMeshes, whatDipsIntoAnOpenBoxBetweenTwoCycles_wasInContact) {
  CycleSetup setup =
      partsSetup({{openBox(), partAt(kBall, {0, 0, 0.2})}, {partAt(kTool, {0, 0, 0})}}, 0.0);
  setup.is_continuous = true;
  for (const bool tells_all : {true, false}) {
    CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
    buffers.refine.tells_all = tells_all;
    LinkPoses poses = restingPoses(setup);
    for (int cycle = 0; cycle < 5; ++cycle) {
      poses.stamp_ns += 10'000'000;
      Pose& tool = poses.world_from_link[1];
      const double angle = cycle > 0 && cycle % 2 == 1 ? 1.047 : -1.047;
      tool.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
      tool.translation = Eigen::Vector3d(0, 0, 0.08) + tool.rotation * Eigen::Vector3d(0, 0, -0.1);
      runCycle(setup, poses, buffers);
      if (cycle > 0) {
        EXPECT_NE(buffers.events.passed[0], kNone) << cycle;
      }
    }
  }
}

TEST(PartsAndOpenMeshes, atThePosesOfTheLastMeasurement_nearestIsTold) {
  const CycleSetup setup = partsSetup({{openBox(), partAt(kBall, {0, 0, 0.14})},
                                       {partAt(kTool, {0, 0, 0})},
                                       {partAt(kBall, {0, 0, 0})}},
                                      0.01);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation.z() = -1.05;  // nearest of all, under the box
  for (int cycle = 0; cycle < 8; ++cycle) {
    buffers.refine.tells_all = cycle >= 6;
    poses.stamp_ns += 10'000'000;
    poses.world_from_link[1].translation = {cycle == 3 ? 0.2 : 0.0, 0.0, cycle == 7 ? 0.045 : 0.03};
    poses.velocities.of_link[1].linear.x() = cycle == 0 ? 3.0 : 0.0;
    runCycle(setup, poses, buffers);
  }
  EXPECT_EQ(buffers.events.verdicts[0], Verdict::warning);
  ASSERT_NE(buffers.events.closest[0], kNone);
  EXPECT_NEAR(buffers.distances.pairs[buffers.events.closest[0]].measured.distance, 0.045, 1e-6);
}

TEST(PartsAndOpenMeshes, afterATurnWhileASetUpWasPrepared_nearestIsTold) {
  const CycleSetup setup = partsSetup({{partAt(Box{{0.5, 0.01, 0.01}}, {0, 0, 0})},
                                       {partAt(kBall, {0.53, 0, 0}), partAt(kBall, {0, 0.56, 0})},
                                       {partAt(kBall, {0, 0, 0})}},
                                      0.0);
  CycleBuffers former = makeBuffers(setup, BroadPhaseKind::automatic);
  CycleBuffers next = makeBuffers(setup, BroadPhaseKind::automatic);
  const VelocityTracker tracker = makeVelocityTracker(setup.model);
  VelocityTracker next_tracker = tracker;
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation.x() = 0.575;  // nearest of all
  runCycle(setup, poses, former);
  const LinkPoses prepared = poses;
  prepareFirstCycle(setup, prepared, next);
  for (int degree = 1; degree <= 90; ++degree) {
    poses.stamp_ns += 10'000'000;
    poses.world_from_link[0].rotation =
        Eigen::AngleAxisd(degree * M_PI / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    runCycle(setup, poses, former);
  }
  const CarryPlan plan = planCarryOver(setup, setup);
  carryMotion(plan, setup, {poses, former.memory.last, tracker}, prepared, next.memory,
              next_tracker);
  carryOver(plan, former.memory, next.memory);
  poses.stamp_ns += 10'000'000;
  runCycle(setup, poses, next);
  EXPECT_EQ(next.events.verdicts[0], Verdict::warning);
  ASSERT_NE(next.events.closest[0], kNone);
  EXPECT_NEAR(next.distances.pairs[next.events.closest[0]].measured.distance, 0.04, 1e-6);
}

}  // namespace
}  // namespace collision_monitor::test::parts_and_open_meshes
