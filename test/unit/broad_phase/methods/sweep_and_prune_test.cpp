// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/sweep_and_prune.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boxes_along_x.h"

namespace collision_monitor::test {
namespace {

TEST(SweepAndPrune, firstCall_sortsAnewAndTheNextDoesNot) {
  SweepAndPrune method(3);
  Boxes boxes = chainOfBoxes(3);
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{0, 1}, {1, 2}}));
  EXPECT_TRUE(method.isAnew());
  moveAlongX(0.125F, boxes);
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{0, 1}, {1, 2}}));
  EXPECT_FALSE(method.isAnew());
}

TEST(SweepAndPrune, endsThatPassEachOther_addAndPartPairs) {
  SweepAndPrune method(3);
  Boxes boxes = chainOfBoxes(3);
  meetingsInOrder(method, boxes);
  boxes[1] = boxAlongX(3, 3.5F);  // past 2, which ends at 3.25
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{1, 2}}));
  boxes[0] = boxAlongX(3.25F, 4);  // begins where 2 ends
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_FALSE(method.isAnew());
}

TEST(SweepAndPrune, endsThatPassOnOneAxisAlone_addNone) {
  SweepAndPrune method(2);
  Boxes boxes{boxAlongX(0, 1), boxAlongX(2, 3)};
  boxes[1].min[2] = 5.0F;
  boxes[1].max[2] = 6.0F;
  meetingsInOrder(method, boxes);
  boxes[1].min[0] = 0.5F;
  EXPECT_TRUE(meetingsInOrder(method, boxes).empty());
  boxes[1].min[2] = 0.5F;
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{0, 1}}));
}

TEST(SweepAndPrune, bodyThatBecomesKnownAndUnknown_bringsItsPairsAndTakesThem) {
  SweepAndPrune method(8);
  Boxes boxes = chainOfBoxes(8);
  const SmallBox second = boxes[1];
  boxes[1] = emptyBox();
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}}));
  boxes[1] = second;
  const Meetings all{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}};
  EXPECT_EQ(meetingsInOrder(method, boxes), all);
  EXPECT_FALSE(method.isAnew());
  boxes[1] = emptyBox();
  EXPECT_EQ(meetingsInOrder(method, boxes).size(), 5U);
  EXPECT_FALSE(method.isAnew());
}

/// 200 boxes in the reverse order: 400 passes a body, on one axis alone.
TEST(SweepAndPrune, motionThatIsNotCoherent_sortsAnewAndFindsTheSame) {
  SweepAndPrune method(200);
  Boxes boxes = chainOfBoxes(200);
  const Meetings chain = meetingsInOrder(method, boxes);
  EXPECT_EQ(chain.size(), 199U);
  std::reverse(boxes.begin(), boxes.end());
  EXPECT_EQ(meetingsInOrder(method, boxes), chain);
  EXPECT_TRUE(method.isAnew());
  EXPECT_EQ(meetingsInOrder(method, boxes), chain);
  EXPECT_FALSE(method.isAnew());
}

}  // namespace
}  // namespace collision_monitor::test
