// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/budget_use.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "support/allocation_guard.h"
#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"

// What is told of a budget that does not suffice.
namespace collision_monitor {
namespace {

using Scene = test::RefineScene;

constexpr LinkPairIndex kBallAndShell = 0;  // of links 0 and 1
constexpr LinkPairIndex kAngles = 5;        // of links 2 and 3

/// A ball in the hollow of a shell, which takes long to measure, and far from them two angles
/// hooked into each other, which take little.
Scene shellAndAngles(bool is_continuous = false) {
  const TriangleMesh ball = test::sphereMesh(0.1, 24);
  TriangleMesh hollow = test::sphereMesh(0.19, 24);
  for (auto& [a, b, c] : hollow.triangles) {
    std::swap(b, c);
  }
  const TriangleMesh shell = test::joined(test::sphereMesh(0.2, 24), hollow);
  CycleSetup setup = test::geometrySetup({ball, shell, test::angleMesh(), test::angleMesh()},
                                         test::optionsFor(RefineGeometry::mesh));
  setup.is_continuous = is_continuous;
  Scene scene(std::move(setup));
  const Pose away{Eigen::Matrix3d::Identity(), {5.0, 0.0, 0.0}};
  scene.poses.world_from_link[2] = away;
  scene.poses.world_from_link[3] = away * test::hookedPose();
  return scene;
}

template <class Task>
std::uint64_t sumOfSteps(const std::vector<Task>& tasks) {
  return std::accumulate(tasks.begin(), tasks.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Task& task) { return sum + task.work; });
}

TEST(BudgetUse, budgetThatDoesNotSuffice_namesThePairsThatTookMost) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.refine.limits.budget = 1000000;
  scene.run();
  scene.buffers.refine.limits.budget =
      static_cast<std::uint32_t>(scene.buffers.counters.refine_work / 2);
  resetMemory(scene.buffers);
  scene.run();
  ASSERT_GT(scene.buffers.counters.left, 0U);
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.cycles, 1U);
  EXPECT_EQ(tally.use.short_cycles, 1U);
  EXPECT_EQ(tally.use.short_work, scene.buffers.counters.refine_work);
  EXPECT_EQ(tally.use.short_time, 0.001);
  EXPECT_EQ(tally.use.most[0].link_pair, kBallAndShell);
  EXPECT_EQ(tally.use.most[1].link_pair, kAngles);
  EXPECT_GT(tally.use.most[0].work, tally.use.most[1].work);
  EXPECT_GT(tally.use.most[1].work, 0U);
  EXPECT_EQ(tally.use.most[0].work + tally.use.most[1].work, tally.use.short_work);
  EXPECT_EQ(tally.use.most[2].link_pair, kNone);
}

TEST(BudgetUse, budgetThatSuffices_stepsAloneAreTold) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.refine.limits.budget = 1000000;
  scene.run();
  addCycle(scene.buffers, 0.001, tally);
  const std::uint64_t first = scene.buffers.counters.refine_work;
  scene.run();
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.cycles, 2U);
  EXPECT_EQ(tally.use.short_cycles, 0U);
  EXPECT_EQ(tally.use.work, first) << "nothing moved";
  EXPECT_EQ(tally.use.worst, first);
  EXPECT_EQ(tally.use.short_work, 0U);
  EXPECT_EQ(tally.use.short_time, 0.0);
  EXPECT_EQ(tally.use.most[0].link_pair, kNone);
}

TEST(BudgetUse, noBudget_noPairTookAny) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.short_cycles, 1U);
  EXPECT_EQ(tally.use.work, 0U);
  EXPECT_EQ(tally.use.most[0].link_pair, kNone);
}

TEST(BudgetUse, stepsOfThePairs_areThoseOfTheCycle) {
  Scene scene = shellAndAngles();
  for (const std::uint32_t budget : {0U, 10U, 300U, 8000U, 1000000U}) {
    scene.buffers.refine.limits.budget = budget;
    scene.moveTo(0, 1e-3 * budget / 1000000U);
    scene.run();
    EXPECT_EQ(sumOfSteps(scene.buffers.refine.tasks), scene.buffers.counters.refine_work);
  }
  scene.moveTo(0, 0.1);  // they overlap, and their depth is looked for
  scene.run();
  EXPECT_EQ(scene.buffers.events.overall, Verdict::contact);
  EXPECT_EQ(sumOfSteps(scene.buffers.refine.tasks), scene.buffers.counters.refine_work);
}

TEST(BudgetUse, wayThatTheBudgetDoesNotSufficeFor_counts) {
  Scene scene = shellAndAngles(true);
  scene.poses.stamp_ns = 1'000'000'000;
  scene.buffers.refine.limits.budget = 1000000;
  scene.moveTo(0, -0.085);
  scene.run();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.refine.limits.budget = 7000;
  scene.poses.stamp_ns += 1'000'000;
  scene.moveTo(0, 0.085);  // farther than both gaps
  scene.run();
  EXPECT_GT(scene.buffers.sweep.work_done, 0U);
  EXPECT_EQ(sumOfSteps(scene.buffers.sweep.tasks), scene.buffers.sweep.work_done);
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.short_cycles, 1U);
  EXPECT_EQ(tally.use.work, scene.buffers.refine.work_done + scene.buffers.sweep.work_done);
  EXPECT_EQ(tally.use.most[0].link_pair, kBallAndShell);
}

TEST(BudgetUse, largestBudgetThatThereIs_leavesNoWayOpen) {
  SetupOptions options;
  options.refine.limits.budget = 4'000'000'000U;
  const TriangleMesh prism = test::prismMesh(0.1, 0.1, 6);
  CycleSetup setup = test::geometrySetup({prism, prism}, options);
  setup.is_continuous = true;
  Scene scene(std::move(setup));
  for (const double side : {-1.0, 1.0}) {
    scene.poses.stamp_ns += 20'000'000;
    scene.poses.world_from_link[1].translation = {0.0, 0.3 * side, 0.2 + 0.02 * side};
    scene.run();
  }
  EXPECT_GT(scene.buffers.counters.swept, 0U);
  EXPECT_EQ(scene.buffers.counters.swept_left, 0U);
}

TEST(BudgetUse, wayThatIsLeftOpenWithStepsToSpare_isNoWantOfBudget) {
  Scene scene = shellAndAngles(true);
  scene.run();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.counters.left = 0;
  scene.buffers.counters.swept_left = 1;
  scene.buffers.sweep.budget = 100;
  scene.buffers.sweep.work_done = 99;
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.short_cycles, 0U);
  scene.buffers.sweep.work_done = 100;
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(tally.use.short_cycles, 1U);
}

/// A cycle in which pairs of elements, each the one of its links, took these steps.
void addShortCycle(const std::vector<std::uint32_t>& work, Scene& scene, BudgetTally& tally) {
  scene.buffers.counters.left = 1;
  scene.buffers.refine.tasks.clear();
  for (ElementPairIndex pair = 0; pair < work.size(); ++pair) {
    RefineTask task;
    task.pair = pair;
    task.work = work[pair];
    scene.buffers.refine.tasks.push_back(task);
  }
  addCycle(scene.buffers, 0.001, tally);
}

std::vector<std::pair<LinkPairIndex, std::uint64_t>> mostOf(const BudgetTally& tally) {
  std::vector<std::pair<LinkPairIndex, std::uint64_t>> most;
  for (const PairWork& pair : tally.use.most) {
    most.emplace_back(pair.link_pair, pair.work);
  }
  return most;
}

TEST(BudgetUse, stepsOfSeveralCycles_addUpByPairOfLinks) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  addShortCycle({50, 10, 40, 30, 0, 20}, scene, tally);
  EXPECT_EQ(mostOf(tally), (decltype(mostOf(tally)){{0, 50}, {2, 40}, {3, 30}}));
  addShortCycle({0, 45, 0, 0, 5, 15}, scene, tally);
  EXPECT_EQ(mostOf(tally), (decltype(mostOf(tally)){{1, 55}, {0, 50}, {2, 40}}));
  addShortCycle({0, 0, 0, 0, 100, 0}, scene, tally);
  EXPECT_EQ(mostOf(tally), (decltype(mostOf(tally)){{4, 105}, {1, 55}, {0, 50}}));
}

TEST(BudgetUse, restart_forgetsAll) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  addShortCycle({50, 10, 40, 30, 0, 20}, scene, tally);
  restart(tally);
  EXPECT_EQ(tally.use.cycles, 0U);
  EXPECT_EQ(tally.use.setup, &scene.setup);
  EXPECT_EQ(tally.use.most[0].link_pair, kNone);
  addShortCycle({0, 7, 0, 0, 0, 0}, scene, tally);
  EXPECT_EQ(mostOf(tally), (decltype(mostOf(tally)){{1, 7}, {kNone, 0}, {kNone, 0}}));
  EXPECT_EQ(tally.use.short_cycles, 1U);
}

TEST(BudgetUse, addingACycle_allocatesNothing) {
  Scene scene = shellAndAngles();
  BudgetTally tally = makeBudgetTally(scene.setup);
  scene.buffers.refine.limits.budget = 300;
  scene.run();
  const test::AllocationGuard guard;
  addCycle(scene.buffers, 0.001, tally);
  restart(tally);
  addCycle(scene.buffers, 0.001, tally);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor
