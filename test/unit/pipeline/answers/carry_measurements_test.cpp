// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_measurements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "pipeline/cycle/run_cycle.h"
#include "pipeline/world/add_world.h"
#include "support/robots/balls_in_a_hollow.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

constexpr std::uint32_t kBudget = 100000;

/// Balls in a hollow beside far boxes, the first of them with a name that comes before the others.
CycleSetup hollowBeside(std::size_t boxes) {
  std::vector<WorldObject> objects;
  for (std::size_t i = 0; i < boxes; ++i) {
    const auto y = static_cast<double>(i);
    objects.push_back(objectOf("box_" + std::to_string(9 - i), Box{{0.1, 0.1, 0.1}}, at(5, y, 0)));
  }
  const CycleSetup robots = ballsInAHollow(kBudget);
  const World world = worldOf(objects, placesOf(robots.model, "map"));
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

/// A set-up and its cycles at one place.
struct Watched {
  explicit Watched(CycleSetup made)
      : setup(std::move(made)), buffers(makeBuffers(setup, BroadPhaseKind::automatic)) {
    const LinkPoses in_hollow = posesInAHollow(ballsInAHollow(kBudget));
    poses = knownPoses(setup);
    std::copy(in_hollow.world_from_link.begin(), in_hollow.world_from_link.end(),
              poses.world_from_link.begin());
    for (std::size_t i = in_hollow.world_from_link.size(); i < setup.model.links.size(); ++i) {
      const auto& joint = setup.model.links[i].parent_joint;
      poses.world_from_link[i] = joint ? setup.model.joint(*joint).parent_from_joint : Pose();
    }
  }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
};

TEST(PlanMeasurements, pairsOfRobots_areTheSameWhateverObjectsThereAre) {
  const CycleSetup from = hollowBeside(1);
  const CycleSetup to = hollowBeside(3);
  const std::vector<ElementPairIndex> new_of = planMeasurements(from, to, planCarryOver(from, to));
  ASSERT_EQ(new_of.size(), from.element_pairs.size());
  std::size_t carried = 0;
  for (std::size_t i = 0; i < new_of.size(); ++i) {
    if (new_of[i] != kNone) {
      ++carried;
      EXPECT_EQ(to.element_pairs[new_of[i]].a, from.element_pairs[i].a);
      EXPECT_EQ(to.element_pairs[new_of[i]].b, from.element_pairs[i].b);
    }
  }
  EXPECT_EQ(carried, ballsInAHollow(kBudget).element_pairs.size());
}

TEST(PlanMeasurements, otherPairsOfRobots_areNotTakenOver) {
  const CycleSetup from = hollowBeside(1);
  CycleSetup to = from;
  to.checked[0].b = LinkId{2};  // in place of link 1
  EXPECT_TRUE(planMeasurements(from, to, planCarryOver(from, to)).empty());
  EXPECT_TRUE(planMeasurements(to, from, planCarryOver(to, from)).empty());
}

TEST(CarryMeasurements, pairsOfRobots_areNotMeasuredAnew) {
  Watched former(hollowBeside(1));
  learnPairs(former.setup, former.poses, former.buffers);
  runCycle(former.setup, former.poses, former.buffers);
  runCycle(former.setup, former.poses, former.buffers);
  ASSERT_GT(former.buffers.counters.refined, 5U);
  ASSERT_EQ(former.buffers.counters.refine_work, 0U) << "it stands";
  ASSERT_NE(former.buffers.events.overall, Verdict::contact);

  Watched next(hollowBeside(3));
  const std::vector<ElementPairIndex> new_of =
      planMeasurements(former.setup, next.setup, planCarryOver(former.setup, next.setup));
  next.buffers.refine.skips_robots = true;
  prepareFirstCycle(next.setup, next.poses, next.buffers);
  EXPECT_EQ(next.buffers.counters.refined, 0U) << "the boxes are far";
  carryMeasurements(new_of, former.buffers, next.buffers);
  runCycle(next.setup, next.poses, next.buffers);
  EXPECT_EQ(next.buffers.counters.refined, former.buffers.counters.refined);
  EXPECT_EQ(next.buffers.counters.refine_work, 0U);
  EXPECT_NE(next.buffers.events.overall, Verdict::contact);
}

TEST(CarryMeasurements, pairsThatTheBudgetStarves_areStarvedNoLonger) {
  Watched former(hollowBeside(0));
  former.buffers.refine.limits.budget = 0;
  runCycle(former.setup, former.poses, former.buffers);
  runCycle(former.setup, former.poses, former.buffers);
  const auto& starved = former.buffers.memory.starved_cycles;
  ASSERT_EQ(*std::max_element(starved.begin(), starved.end()), 2U);
  Watched next(hollowBeside(3));
  const std::vector<ElementPairIndex> new_of =
      planMeasurements(former.setup, next.setup, planCarryOver(former.setup, next.setup));
  carryMeasurements(new_of, former.buffers, next.buffers);
  for (std::size_t i = 0; i < starved.size(); ++i) {
    EXPECT_EQ(next.buffers.memory.starved_cycles[new_of[i]], starved[i]);
  }
}

}  // namespace
}  // namespace collision_monitor::test
