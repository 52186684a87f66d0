// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/startup_report.h"

#include <gtest/gtest.h>

#include "edge_scene.h"

namespace collision_monitor::test {
namespace {

TEST(StartupReport, summary_tellsTheRateThatIsKept) {
  MonitorSetup setup = *slidingSetup();
  EXPECT_EQ(summaryOf(setup),
            "watching 1 robot in frame 'base': 4 shapes, 3 pairs of links, at 100 Hz; 1 warning");
  setup.parameters.trigger = Trigger::pose;
  setup.parameters.rate = 0.5;  // heartbeats are to come twice a second
  EXPECT_NE(summaryOf(setup).find("at most 2 Hz"), std::string::npos) << summaryOf(setup);
}

}  // namespace
}  // namespace collision_monitor::test
