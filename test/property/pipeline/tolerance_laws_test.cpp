// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

// What a tolerance of distances may change, and what it may not.
namespace collision_monitor::test::tolerance_laws {
namespace {

constexpr std::uint32_t kAmple = 10000000;

CycleSetup setupOf(const std::vector<Geometry>& geometries, double contact_distance = 0.0) {
  SetupOptions options;
  options.default_limits.max_shapes = 2;
  options.limits.contact_distance = contact_distance;
  CycleSetup setup = geometrySetup(geometries, options);
  setup.is_continuous = false;
  setup.refine.budget = kAmple;
  return setup;
}

CycleBuffers buffersWithin(double tolerance, const CycleSetup& setup) {
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  buffers.refine.limits.tolerance = tolerance;
  return buffers;
}

void creep(Random& random, LinkPoses& poses) {
  for (Pose& pose : poses.world_from_link) {
    pose = random() % 1000 == 0 ? randomPose(random, 0.25) : pose;
    pose.translation += randomPoint(random, 2e-4);
  }
}

const PairDistance* nearestOf(const CycleBuffers& buffers, std::size_t pair) {
  const std::uint32_t place = buffers.events.closest[pair];
  return place == kNone ? nullptr : &buffers.distances.pairs[place];
}

/// It may shorten a distance past a threshold; and what has hardly moved is not measured.
TEST(ToleranceLaws, noVerdictIsAnother_andNoDistanceShortByMore) {
  constexpr double kTolerance = 5e-3;
  const CycleSetup setup = setupOf({bumpyMesh(0.2, 16), angleMesh(), Cylinder{0.1, 0.05},
                                    Box{{0.1, 0.04, 0.03}}, bumpyMesh(0.1, 12)});
  CycleBuffers exact = buffersWithin(0.0, setup);
  CycleBuffers tolerant = buffersWithin(kTolerance, setup);
  LinkPoses poses = randomLinkPoses(setup, 0.25, kSeed);
  Random random(kSeed);
  int shorter = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    creep(random, poses);
    runCycle(setup, poses, exact);
    runCycle(setup, poses, tolerant);
    ASSERT_EQ(exact.events.verdicts, tolerant.events.verdicts) << cycle;
    for (std::size_t pair = 0; pair < setup.checked.size(); ++pair) {
      const PairDistance* truth = nearestOf(exact, pair);
      const PairDistance* found = nearestOf(tolerant, pair);
      if (truth != nullptr && found != nullptr && truth->quality == Quality::exact &&
          found->quality == Quality::exact) {
        const double short_by = truth->measured.distance - found->measured.distance;
        ASSERT_GE(short_by, -1e-9) << cycle;
        ASSERT_LE(short_by, kTolerance + 1e-9) << cycle;
        shorter += short_by > 1e-9 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(shorter, 1000) << "the tolerance is not used";
}

/// Where the budget ended before it was known on which side of the threshold a pair is. What is
/// told meanwhile has its own points.
TEST(ToleranceLaws, shortBudgetAtAThreshold_isMadeUpForAtRest) {
  constexpr double kContact = 0.02;
  CycleSetup setup = setupOf({bumpyMesh(0.2, 16), bumpyMesh(0.1, 12)}, kContact);
  setup.limits.hysteresis = 0.0;
  Random random(kSeed);
  int beyond = 0;
  for (int round = 0; round < 300; ++round) {
    LinkPoses poses = randomLinkPoses(setup, 0.15, kSeed + static_cast<unsigned>(round));
    CycleBuffers exact = buffersWithin(0.0, setup);
    runCycle(setup, poses, exact);
    const PairDistance* nearest = nearestOf(exact, 0);
    if (nearest == nullptr || nearest->quality != Quality::exact) {
      continue;
    }
    const double travel = kContact + uniform(random, 0.0, 1e-3) - nearest->measured.distance;
    poses.world_from_link[1].translation += travel * nearest->measured.normal_a_to_b;
    resetMemory(exact);
    runCycle(setup, poses, exact);
    CycleBuffers tolerant = buffersWithin(2e-3, setup);
    tolerant.refine.limits.budget = 20 + static_cast<std::uint32_t>(random() % 1500);
    runCycle(setup, poses, tolerant);
    poses.world_from_link[1].translation += randomPoint(random, 2e-4);
    runCycle(setup, poses, tolerant);
    const SignedDistance& told = nearestOf(tolerant, 0)->measured;
    ASSERT_LE((told.point_on_b - told.point_on_a - told.distance * told.normal_a_to_b).norm(), 1e-9)
        << round;
    runCycle(setup, poses, exact);
    tolerant.refine.limits.budget = kAmple;
    runCycle(setup, poses, tolerant);
    ASSERT_EQ(tolerant.events.verdicts, exact.events.verdicts) << round;
    beyond += exact.events.verdicts[0] == Verdict::warning ? 1 : 0;
  }
  EXPECT_GT(beyond, 50);
}

}  // namespace
}  // namespace collision_monitor::test::tolerance_laws
