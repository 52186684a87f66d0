// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/cycle_statistics.h"

#include <gtest/gtest.h>

#include "ros_edge/services/enabling.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

TEST(CycleStatistics, nothingYet_isZero) {
  const CycleStatistics statistics;
  EXPECT_EQ(statistics.times().count, 0U);
  EXPECT_EQ(statistics.times().worst, 0.0);
}

TEST(CycleStatistics, medianAndWorst) {
  CycleStatistics statistics;
  for (const double time : {5.0, 1.0, 4.0, 2.0, 3.0}) {
    statistics.addCycle(time, false, RealTimeState::off);
  }
  EXPECT_EQ(statistics.times().median, 3.0);
  EXPECT_EQ(statistics.times().worst, 5.0);
  EXPECT_EQ(statistics.times().count, 5U);
}

TEST(CycleStatistics, oldTimesAreForgotten) {
  CycleStatistics statistics;
  statistics.addCycle(100.0, false, RealTimeState::off);
  for (int i = 0; i < 1024; ++i) {
    statistics.addCycle(1.0, false, RealTimeState::off);
  }
  EXPECT_EQ(statistics.times().worst, 1.0);
}

TEST(CycleStatistics, everyCycleCounts) {
  CycleStatistics statistics;
  const CycleCounts before = statistics.counts();
  EXPECT_EQ(before.cycles, 0U);
  for (int i = 0; i < 2000; ++i) {
    statistics.addCycle(1.0, i % 100 == 0, RealTimeState::off);
  }
  EXPECT_EQ(statistics.counts().cycles, 2000U);
  EXPECT_EQ(statistics.counts().overruns, 20U);
  EXPECT_GE(statistics.counts().newest_end, before.newest_end);
  EXPECT_EQ(statistics.times().count, 1024U);
}

using CycleStatisticsTest = EdgeScene;

TEST_F(CycleStatisticsTest, useOfTheBudget_isThatSinceItWasTaken) {
  CycleStatistics statistics;
  const auto watch = watchAt(0.25);
  watch->buffers.counters.left = 1;
  watch->buffers.refine.work_done = 10;
  for (int i = 0; i < 3; ++i) {
    statistics.addWork(watch->buffers, 0.001, watch->budget);
  }
  const BudgetUse first = statistics.takeBudgetUse();
  EXPECT_EQ(first.setup, &setup_->setup);
  EXPECT_EQ(first.short_cycles, 3U);
  EXPECT_EQ(first.short_work, 30U);
  EXPECT_EQ(statistics.takeBudgetUse().cycles, 0U) << "none since";
  statistics.addWork(watch->buffers, 0.001, watch->budget);
  const BudgetUse second = statistics.takeBudgetUse();
  EXPECT_EQ(second.cycles, 1U);
  EXPECT_EQ(second.work, 10U);
}

TEST_F(CycleStatisticsTest, useOfTheBudget_endsWithItsSetup) {
  CycleStatistics statistics;
  const auto watch = watchAt(0.25);
  statistics.addWork(watch->buffers, 0.001, watch->budget);
  const auto next_setup = slidingSetup();
  statistics.startWork(makeBudgetTally(next_setup->setup));
  EXPECT_EQ(statistics.takeBudgetUse().setup, &next_setup->setup);
  EXPECT_EQ(statistics.takeBudgetUse().cycles, 0U);
}

TEST(Enabling, offForAWhile_onAgainByItself) {
  Enabling enabling;
  const ros::SteadyTime now = ros::SteadyTime::now();
  EXPECT_TRUE(enabling.isOn(now));
  enabling.switchOffFor(1000.0);
  EXPECT_FALSE(enabling.isOn(now));
  EXPECT_TRUE(enabling.isOn(ros::SteadyTime::now() + ros::WallDuration(1001.0)));
  enabling.switchOn();
  EXPECT_TRUE(enabling.isOn(now));
}

}  // namespace
}  // namespace collision_monitor::test
