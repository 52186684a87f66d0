// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Users saw false contacts in the first cycles, after a reload and after an outage of poses.
// Many links came to be known at once, and one cycle has no budget to refine all their pairs.
// Now the node measures them first, judging nothing, for as many cycles as that takes.
#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/balls_in_a_hollow.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

/// Balls in a hollow, and what cycles need.
struct BallsInAHollow {
  explicit BallsInAHollow(std::uint32_t budget)
      : setup(ballsInAHollow(budget)),
        buffers(makeBuffers(setup, BroadPhaseKind::automatic)),
        poses(posesInAHollow(setup)) {}

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
};

TEST(FirstVerdicts, moreThanOneCycleMeasures_theFirstVerdictIsOfTheGeometries) {
  constexpr std::uint32_t kBudget = 150;
  BallsInAHollow unlearned(kBudget);
  runCycle(unlearned.setup, unlearned.poses, unlearned.buffers);
  ASSERT_GT(unlearned.buffers.counters.left, 0U);
  EXPECT_EQ(unlearned.buffers.events.overall, Verdict::contact) << "of enclosing shapes";

  BallsInAHollow scene(kBudget);
  learnPairs(scene.setup, scene.poses, scene.buffers);
  runCycle(scene.setup, scene.poses, scene.buffers);
  EXPECT_EQ(scene.buffers.counters.left, 0U);
  EXPECT_NE(scene.buffers.events.overall, Verdict::contact);
  EXPECT_TRUE(scene.buffers.distances.passed.empty());
}

TEST(FirstVerdicts, betweenTwoCycles_changesNoStep) {
  CycleSetup setup =
      handMadeSetup({{0, Box{{0.001, 0.3, 0.3}}}, {1, Sphere{0.01}}, {2, Sphere{0.01}}});
  setup.is_continuous = true;
  double longest = 0.0;
  for (const bool learns : {false, true}) {
    CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
    LinkPoses poses = knownPoses(setup);
    poses.world_from_link[1].translation.x() = -0.5;
    poses.world_from_link[2].translation.z() = 5.0;
    poses.status[2] = LinkStatus::missing;
    for (int cycle = 1; cycle <= 3; ++cycle) {
      poses.stamp_ns = 1'000'000'000 + cycle * 20'000'000;
      if (cycle == 3) {
        poses.world_from_link[1].translation.x() += 0.32;  // it was at rest
        poses.status[2] = LinkStatus::known;
        if (learns) {
          learnPairs(setup, poses, buffers);
        }
      }
      runCycle(setup, poses, buffers);
    }
    EXPECT_TRUE(buffers.sweep.step.on_way.is_exceeded);
    longest = learns ? longest : buffers.sweep.step.on_way.longest;
    EXPECT_EQ(buffers.sweep.step.on_way.longest, longest);
  }
}

TEST(FirstVerdicts, noBudgetAtAll_ends) {
  BallsInAHollow scene(0);
  learnPairs(scene.setup, scene.poses, scene.buffers);
  runCycle(scene.setup, scene.poses, scene.buffers);
  EXPECT_EQ(scene.buffers.events.overall, Verdict::contact);
}

TEST(FirstVerdicts, nothingIsKnown_changesNothing) {
  BallsInAHollow scene(8000);
  scene.poses.status.assign(scene.poses.status.size(), LinkStatus::missing);
  learnPairs(scene.setup, scene.poses, scene.buffers);
  runCycle(scene.setup, scene.poses, scene.buffers);
  EXPECT_EQ(scene.buffers.events.overall, Verdict::unknown);
}

}  // namespace
}  // namespace collision_monitor::test
