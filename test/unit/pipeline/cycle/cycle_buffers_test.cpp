// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/cycle_buffers.h"

#include <gtest/gtest.h>

#include "two_balls.h"

namespace collision_monitor::test {
namespace {

class CycleBuffersTest : public TwoBalls {};

TEST_F(CycleBuffersTest, resetMemory_forgetsHysteresis) {
  runWithGap(0.04);
  resetMemory(buffers_);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(CycleBuffersTest, forgetPoses_leavesWhatWasReportedToBeTakenBack) {
  runWithGap(-0.01);
  forgetPoses(buffers_);
  runWithGap(0.06);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::contact);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::clear);
}

}  // namespace
}  // namespace collision_monitor::test
