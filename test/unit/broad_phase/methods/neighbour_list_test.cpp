// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/neighbour_list.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boxes_along_x.h"

namespace collision_monitor::test {
namespace {

/// A list of ten boxes that has seen two steps of 10 mm.
class NeighbourListTest : public testing::Test {
 protected:
  NeighbourListTest() {
    meetingsInOrder(method_, boxes_);
    for (int step = 0; step < 2; ++step) {
      moveAlongX(0.01F, boxes_);
      meetingsInOrder(method_, boxes_);
    }
  }

  NeighbourList method_{10};
  Boxes boxes_ = chainOfBoxes(10);
};

TEST_F(NeighbourListTest, evenMotion_isCoherentOnceItIsSeen) {
  EXPECT_TRUE(method_.isCoherent());
  EXPECT_GT(method_.work(), 0U);
  NeighbourList fresh(10);
  meetingsInOrder(fresh, boxes_);
  EXPECT_FALSE(fresh.isCoherent()) << "one call tells nothing of the motion";
}

TEST_F(NeighbourListTest, pairsAreSorted) {
  const Meetings found = meetingsInOrder(method_, boxes_);
  EXPECT_EQ(found.size(), 9U);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
}

TEST_F(NeighbourListTest, smallMotionWithinTheMargin_partsAndJoinsPairs) {
  boxes_[0].max[0] = boxes_[1].min[0] - 0.001F;  // 0.25 m back, inward: the list stands
  EXPECT_EQ(meetingsInOrder(method_, boxes_).size(), 8U);
  boxes_[0].max[0] = boxes_[1].min[0];
  EXPECT_EQ(meetingsInOrder(method_, boxes_).size(), 9U);
}

TEST_F(NeighbourListTest, motionPastTheMargin_findsWhatIsThere) {
  boxes_[0] = boxAlongX(7.5F, 7.75F);  // in 7 alone
  const Meetings found = meetingsInOrder(method_, boxes_);
  EXPECT_EQ(found.size(), 9U);
  EXPECT_EQ(found.front(), (std::pair<std::uint32_t, std::uint32_t>(0, 7)));
}

TEST_F(NeighbourListTest, jumpsOfManyWidths_areNotCoherent) {
  moveAlongX(100.0F, boxes_);
  EXPECT_EQ(meetingsInOrder(method_, boxes_).size(), 9U);
  EXPECT_FALSE(method_.isCoherent());
}

TEST_F(NeighbourListTest, nothingMoves_whatWasExpectedStays) {
  for (int call = 0; call < 10; ++call) {
    EXPECT_EQ(meetingsInOrder(method_, boxes_).size(), 9U);
  }
  EXPECT_TRUE(method_.isCoherent());
}

}  // namespace
}  // namespace collision_monitor::test
