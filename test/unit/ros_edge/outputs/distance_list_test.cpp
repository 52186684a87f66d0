// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/distance_list.h"

#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/judge_pairs.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

using DistanceListTest = EdgeScene;

/// A list that was filled before says what a new one says.
void expectAsNew(DistanceList& used, const Watch& watch) {
  DistanceList unused;
  const Distances& expected = unused.fill(watch);
  const Distances& message = used.fill(watch);
  ASSERT_EQ(message.pairs.size(), expected.pairs.size());
  EXPECT_EQ(message.closest, expected.closest);
  for (std::size_t i = 0; i < expected.pairs.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(message.pairs[i].link_a, expected.pairs[i].link_a);
    EXPECT_EQ(message.pairs[i].link_b, expected.pairs[i].link_b);
    EXPECT_EQ(message.pairs[i].shape_a, expected.pairs[i].shape_a);
    EXPECT_EQ(message.pairs[i].shape_b, expected.pairs[i].shape_b);
    EXPECT_EQ(message.pairs[i].gradient_joints, expected.pairs[i].gradient_joints);
    EXPECT_EQ(message.pairs[i].gradient_values, expected.pairs[i].gradient_values);
    EXPECT_EQ(message.pairs[i].distance, expected.pairs[i].distance);
  }
}

TEST_F(DistanceListTest, entryOfAnotherPair_isNamedAnew) {
  DistanceList list;
  const Distances& message = list.fill(*watchAt(5.0));
  ASSERT_EQ(message.pairs.size(), 1U);
  EXPECT_EQ(message.pairs[0].link_b, "finger");
  EXPECT_EQ(message.pairs[0].gradient_joints, (std::vector<std::string>{"slide"}));
  expectAsNew(list, *watchAt(-0.25));
  EXPECT_EQ(message.pairs[0].link_b, "tool");
  EXPECT_EQ(message.pairs[0].gradient_joints, (std::vector<std::string>{"slide", "reach"}));
}

TEST_F(DistanceListTest, entryThatIsRefinedNow_namesElements) {
  DistanceList list;
  const auto watch = watchAt(-0.25);
  EXPECT_EQ(list.fill(*watch).pairs[0].shape_a, "collision_0/box");
  watch->buffers.distances.pairs[watch->buffers.events.closest_of_all].is_refined = true;
  expectAsNew(list, *watch);
  EXPECT_EQ(list.fill(*watch).pairs[0].shape_a, "collision_0");
}

/// As of two links with several elements.
TEST_F(DistanceListTest, contactThatIsCertain_isNotHiddenByADeeperBound) {
  const auto watch = watchAt(-0.35);
  CycleBuffers& buffers = watch->buffers;
  std::vector<PairDistance>& measured = buffers.distances.pairs;
  PairDistance estimate = measured.at(buffers.events.closest_of_all);
  estimate.quality = Quality::estimate;
  estimate.measured.distance = -0.01;
  measured.at(buffers.events.closest_of_all).quality = Quality::lower_bound;
  PairDistance deeper = estimate;
  deeper.measured.distance = -0.02;
  measured.insert(measured.end(), {deeper, estimate});
  judgePairs(setup_->setup, buffers.body_poses, watch->poses.velocities, buffers.distances,
             buffers.memory, buffers.events);
  DistanceList list;
  const Distances& message = list.fill(*watch);
  ASSERT_EQ(message.pairs.size(), 1U);
  EXPECT_EQ(message.closest, 0);
  EXPECT_EQ(message.pairs[0].quality, LinkDistance::ESTIMATE);
  EXPECT_EQ(message.pairs[0].distance, -0.02);
  EXPECT_EQ(stateOf(*watch, facts()).closest.quality, LinkDistance::ESTIMATE);
}

TEST_F(DistanceListTest, listThatShrinksAndGrows_isAsNew) {
  SetupOptions options;
  options.limits.report_distance = 1.0;
  setup_ = slidingSetup(options);
  DistanceList list;
  EXPECT_EQ(list.fill(*watchAt(-0.25)).pairs.size(), 3U);
  expectAsNew(list, *watchAt(5.0));
  expectAsNew(list, *watchAt(0.25));
  expectAsNew(list, *watchAt(-0.25));
}

}  // namespace
}  // namespace collision_monitor::test
