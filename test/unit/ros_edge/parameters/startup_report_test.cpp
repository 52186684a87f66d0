// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/startup_report.h"

#include <gtest/gtest.h>

#include "ros_edge/outputs/pair_counts.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

TEST(StartupReport, summary_tellsTheRateThatIsKept) {
  MonitorSetup setup = *slidingSetup();
  EXPECT_EQ(summaryOf(setup),
            "watching 1 robot in frame 'base': 4 shapes, 3 pairs of links, at 100 Hz; "
            "not checked: 3 that meet at a joint; 0 warnings");
  setup.parameters.trigger = Trigger::pose;
  setup.parameters.rate = 0.5;  // heartbeats are to come twice a second
  EXPECT_NE(summaryOf(setup).find("at most 2 Hz"), std::string::npos) << summaryOf(setup);
}

TEST(StartupReport, summary_countsPairsByReason) {
  SetupOptions options;
  options.ignored_pairs = {{"base", "*"}};
  EXPECT_EQ(summaryOf(*slidingSetup(options)),
            "watching 1 robot in frame 'base': 4 shapes, 1 pair of links, at 100 Hz; not checked: "
            "2 that meet at a joint, 3 hidden by ignore_pairs; 0 warnings");
  PairCounts counts{};
  counts.fill(2);
  EXPECT_EQ(notCheckedText(counts),
            "; not checked: 2 joined by fixed joints only, 2 that meet at a joint, 2 disabled by "
            "the SRDF, 2 that overlap in the default pose, 2 hidden by ignore_pairs, 2 ignored "
            "by pair_rules, 2 muted, 2 of objects and links that may touch them, 2 of two objects");
  EXPECT_EQ(notCheckedText(PairCounts{}), "");
}

using PairCountsTest = EdgeScene;

TEST_F(PairCountsTest, state_tellsWhatIgnorePairsHides) {
  EXPECT_EQ(stateOf(*watchAt(0.25), facts()).pairs_ignored, 0U);
  SetupOptions options;
  options.ignored_pairs = {{"base", "*"}};
  setup_ = slidingSetup(options);
  EXPECT_EQ(stateOf(*watchAt(0.25), facts()).pairs_ignored, 3U);
}

}  // namespace
}  // namespace collision_monitor::test
