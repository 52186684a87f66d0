// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/islands.h"

#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

TEST(Islands, contactsApart_formTwo) {
  const CycleSetup setup = handMadeSetup(
      {{0, Sphere{1}}, {1, Sphere{1}}, {2, Sphere{1}}, {3, Sphere{1}}, {4, Sphere{1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  const double x[] = {0.0, 10.0, 1.5, 11.5, 20.0};  // 0 touches 2, 1 touches 3, 4 is alone
  for (std::size_t link = 0; link < 5; ++link) {
    poses.world_from_link[link].translation.x() = x[link];
  }
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_count, 2U);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 2, 1, 2, 0}));
  poses.world_from_link[4].translation.x() = 5.5;  // joins nothing: 2 ends at 2.5, 1 starts at 9
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_count, 2U);
}

TEST(Islands, chainOfContacts_isOne) {
  const CycleSetup setup = handMadeSetup({{0, Sphere{1}}, {1, Sphere{1}}, {2, Sphere{1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::sweep_and_prune);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[0].translation.x() = 3.0;  // 1 - 2 - 0
  poses.world_from_link[2].translation.x() = 1.5;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 1, 1}));
}

TEST(Islands, contactThatEnds_leavesNoIsland) {
  const CycleSetup setup = handMadeSetup({{0, Sphere{1}}, {1, Sphere{1}}, {2, Sphere{1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[2].translation.x() = 10.0;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 1, 0}));
  poses.world_from_link[0].translation.x() = 8.5;  // now touches 2 alone
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 0, 1}));
  poses.world_from_link[0].translation.x() = 4.0;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(buffers.events.island_count, 0U);
}

}  // namespace
}  // namespace collision_monitor::test
