// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/hashed_bins.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boxes_along_x.h"

namespace collision_monitor::test {
namespace {

SmallBox cubeAt(float center, float half) {
  const float min = center - half;
  const float max = center + half;
  return {{min, min, min, 0.0F}, {max, max, max, 0.0F}};
}

/// Cubes of 0.1 m half a metre apart along the diagonal: cells are some 0.2 m wide.
Boxes smallCubes() {
  Boxes boxes;
  for (int i = 0; i < 20; ++i) {
    boxes.push_back(cubeAt(0.5F * static_cast<float>(i), 0.05F));
  }
  return boxes;
}

TEST(HashedBins, boxesThatShareManyCells_areOnePair) {
  Boxes boxes = smallCubes();
  boxes[0] = cubeAt(-5.0F, 0.3F);
  boxes[1] = cubeAt(-5.1F, 0.3F);
  HashedBins method(boxes.size());
  EXPECT_EQ(meetingsOf(method, boxes), (Meetings{{0, 1}}));
}

TEST(HashedBins, boxThatWouldStandInVeryManyCells_meetsAllAndEachOnce) {
  Boxes boxes = smallCubes();
  boxes[3] = cubeAt(0.0F, 100.0F);
  boxes[7] = cubeAt(1.0F, 100.0F);
  HashedBins method(boxes.size());
  const Meetings found = meetingsOf(method, boxes);
  EXPECT_EQ(found.size(), 37U) << "18 others each, and the two";
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

TEST(HashedBins, boxThatShrinks_goesFromAsideToItsCells) {
  Boxes boxes = smallCubes();
  boxes[3] = cubeAt(0.0F, 100.0F);
  HashedBins method(boxes.size());
  EXPECT_EQ(meetingsOf(method, boxes).size(), 19U);
  boxes[3] = cubeAt(2.02F, 0.05F);
  EXPECT_EQ(meetingsOf(method, boxes), (Meetings{{3, 4}}));
}

TEST(HashedBins, bodyThatLeavesItsCells_isFoundInTheNext) {
  Boxes boxes = smallCubes();
  HashedBins method(boxes.size());
  EXPECT_TRUE(meetingsOf(method, boxes).empty());
  for (std::uint32_t other = 1; other < boxes.size(); ++other) {
    boxes[0] = cubeAt(0.5F * static_cast<float>(other) + 0.05F, 0.05F);
    EXPECT_EQ(meetingsOf(method, boxes), (Meetings{{0, other}}));
  }
  boxes[0] = emptyBox();
  EXPECT_TRUE(meetingsOf(method, boxes).empty());
}

TEST(HashedBins, widthsThatChange_changeTheCells) {
  Boxes boxes = smallCubes();
  HashedBins method(boxes.size());
  EXPECT_TRUE(meetingsOf(method, boxes).empty());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i] = cubeAt(0.5F * static_cast<float>(i), 0.3F);
  }
  EXPECT_EQ(meetingsOf(method, boxes).size(), 19U);
}

/// Both are beyond the last cell.
TEST(HashedBins, boxesVeryFarAway_meetOnlyWhereTheyDo) {
  Boxes boxes = smallCubes();
  boxes[0] = cubeAt(1e20F, 0.0F);
  boxes[1] = cubeAt(1e21F, 0.0F);
  boxes[2] = cubeAt(1e20F, 0.0F);
  HashedBins method(boxes.size());
  EXPECT_EQ(meetingsOf(method, boxes), (Meetings{{0, 2}}));
}

}  // namespace
}  // namespace collision_monitor::test
