// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/cycle/run_cycle.h"
#include "ros_edge/outputs/sentences.h"
#include "unit/ros_edge/edge_scene.h"

/// What is said of steps between poses that are too long.
namespace collision_monitor::test {
namespace {

class StepsTest : public EdgeScene {};

TEST_F(StepsTest, posesTooFewForTheAcceleration_namePairAndStep) {
  const auto watch = watchAt(0.25);
  for (const double reach : {-1.25, 3.0}) {  // 1.5 m there, and 4.25 m back
    watch->poses = slidingPoses(setup_->setup.model, 0.0, reach);
    watch->poses.stamp_ns = watch->buffers.memory.last.stamp_ns + 30'000'000;
    runCycle(watch->setup(), watch->poses, watch->buffers);
  }
  // 5.75 m in a step bend the way by an eighth of it; both are 0.2 m thick.
  EXPECT_EQ(
      stepSentence(*watch),
      "poses every 30.0 ms are too few: from one to the next, base and tool speed up or slow "
      "down so much that they may pass through each other unseen, though the monitor looks at "
      "the way in between; at these speeds poses are needed every 22.4 ms");
}

TEST_F(StepsTest, stepOverTheCap_isAWarningThatSaysWhatCoversIt) {
  // 0.15 m in 30 ms are 5 m/s; both are 0.2 m thick: poses every 80 ms do. 10 times that do not.
  const auto moved = [&](const std::shared_ptr<const MonitorSetup>& setup, double way) {
    const auto watch = judged(setup, store_, slidingPoses(setup->setup.model, 0.0, 0.25));
    watch->poses = slidingPoses(setup->setup.model, 0.0, 0.25 + way);
    watch->poses.stamp_ns += 30'000'000;
    runCycle(watch->setup(), watch->poses, watch->buffers);
    return stateOf(*watch, facts());
  };
  EXPECT_NEAR(moved(setup_, 0.15).step_cap, 0.4 / 5.0, 1e-9);
  EXPECT_EQ(moved(setup_, 0.15).step_warning, "");
  EXPECT_NEAR(moved(setup_, 1.5).step_cap, 0.4 / 50.0, 1e-9);
  EXPECT_EQ(
      moved(setup_, 1.5).step_warning,
      "base and tool move so fast that they could pass through each other from one pose to the "
      "next (every 30.0 ms); the monitor also looks at the way in between, so nothing is missed "
      "(without that, poses would be needed every 8.0 ms)");
  auto not_continuous = std::make_shared<MonitorSetup>(*setup_);
  not_continuous->setup.is_continuous = false;
  EXPECT_EQ(moved(not_continuous, 1.5).step_warning,
            "poses every 30.0 ms are too few: from one to the next, base and tool can pass through "
            "each other unseen (parameter continuous is off); at these speeds poses are needed "
            "every 8.0 ms");
}

TEST_F(StepsTest, stepsAreCountedOnce) {
  const auto watch = watchAt(0.25);
  StepCount count;
  watch->poses = slidingPoses(setup_->setup.model, 0.0, 1.75);
  watch->poses.stamp_ns += 30'000'000;
  for (int i = 0; i < 3; ++i) {  // the second and third cycle have no new poses
    runCycle(watch->setup(), watch->poses, watch->buffers);
    countStep(watch->buffers.sweep, count);
  }
  EXPECT_EQ(count.over_cap, 1U);
  EXPECT_EQ(count.too_long, 0U);
}

TEST_F(StepsTest, pairsLeft_areThoseStarvedAndThoseWhoseMotionIsOpen) {
  const auto watch = watchAt(0.25);
  watch->buffers.counters.left = 2;
  watch->buffers.counters.swept_left = 3;
  EXPECT_EQ(stateOf(*watch, facts()).pairs_left, 5U);
}

}  // namespace
}  // namespace collision_monitor::test
