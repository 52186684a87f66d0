// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

// A cycle passes over parts of links by how they close. Others then seemed to be all there is: the
// speed scale jumped to 1 while a part that was passed over still closed, and a contact that a time
// held ended where the nearest part was passed over.
namespace collision_monitor::test {
namespace {

CollisionElement partAt(const Geometry& geometry, const Eigen::Vector3d& place) {
  CollisionElement part;
  part.geometry = geometry;
  part.link_from_geometry.translation = place;
  return part;
}

CycleSetup partsSetup(const std::vector<std::vector<CollisionElement>>& links) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  return linkSetup(links, options);
}

LinkPoses restingPoses(const CycleSetup& setup) {
  LinkPoses poses = knownPoses(setup);
  poses.velocities.known.assign(poses.velocities.known.size(), 1);
  poses.stamp_ns = 1'000'000'000;
  return poses;
}

TEST(LoneBodies, whileAFartherPartCloses_scaleGrowsSlowly) {
  const Sphere ball{0.02};
  const CycleSetup setup =
      partsSetup({{partAt(ball, {0.0, 0.0, 0.0}), partAt(ball, {0.4, 0.0, 0.0})},
                  {partAt(ball, {0.0, 0.0, 0.0})}});
  for (const bool tells_all : {true, false}) {
    CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
    buffers.refine.tells_all = tells_all;
    LinkPoses poses = restingPoses(setup);
    poses.world_from_link[1].translation.x() = 0.22;
    double last = 0.0;
    for (int cycle = 0; cycle < 20; ++cycle) {
      poses.stamp_ns += 4'000'000;
      // First a part closes fast; then it parts, and the other closes from farther away.
      const bool closes_fast = cycle < 2;
      poses.velocities.of_link[0].linear.x() = closes_fast ? 2.0 : -0.1;
      poses.world_from_link[0].translation.x() = closes_fast ? 0.0 : 0.04;
      runCycle(setup, poses, buffers);
      if (cycle > 1) {
        EXPECT_LE(buffers.memory.speed.scale, last + 0.0081) << cycle;
      }
      last = buffers.memory.speed.scale;
    }
    EXPECT_GT(last, 0.4);
  }
}

TEST(LoneBodies, aContactByTime_isHeldByItsNearestPart) {
  const Sphere ball{0.02};
  CycleSetup setup = partsSetup(
      {{partAt(ball, {0.4, 0.0, 0.0}), partAt(prismMesh(0.02, 0.02, 5), {0.0, 0.35, 0.0})},
       {partAt(ball, {0.0, 0.0, 0.0})},
       {partAt(ball, {0.0, 0.0, 0.0})}});
  setup.limits.contact_time = 0.08;
  setup.limits.time_hysteresis = 0.03;
  setup.limits.warning_time = 0.0;
  setup.limits.report_distance = 0.1;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation.y() = -0.1;  // nearest of all to link 1
  poses.velocities.of_link[0].linear = {-5.0, -2.0, 0.0};
  for (int cycle = 0; cycle < 4; ++cycle) {
    poses.stamp_ns += 1'000'000;
    if (cycle > 0) {  // the ball closes in 0.09 s, and the nearer mesh parts
      const Eigen::Vector3d spin(0.0, 0.0, -10.0);
      poses.velocities.of_link[0] = {
          Eigen::Vector3d(-4.0, 0.0, 0.0) - spin.cross(Eigen::Vector3d(0.4, 0.0, 0.0)), spin};
    }
    runCycle(setup, poses, buffers);
    EXPECT_EQ(buffers.events.verdicts[0], Verdict::contact) << cycle;
    const std::uint32_t closest = buffers.events.closest[0];
    ASSERT_NE(closest, kNone);
    EXPECT_NEAR(buffers.distances.pairs[closest].measured.distance, 0.31, 0.001);
  }
}

}  // namespace
}  // namespace collision_monitor::test
