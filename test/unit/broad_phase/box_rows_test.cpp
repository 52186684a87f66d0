// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/box_rows.h"

#include <gtest/gtest.h>

#include <limits>

namespace collision_monitor {
namespace {

/// `count` unit cubes side by side along x, one every 0.5 m.
BoxRows cubesAlongX(std::size_t count) {
  BoxRows rows;
  resizeRows(count + kRowPadding, rows);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = 0.5F * static_cast<float>(i);
    setRow(i, static_cast<std::uint32_t>(100 + i), {{x, 0, 0, 0}, {x + 1, 1, 1, 0}}, rows);
  }
  padRows(count, rows);
  return rows;
}

TEST(BoxRows, rowsThatMeetComeInOrder) {
  for (const std::size_t count : {1U, 2U, 5U, 16U, 17U, 18U, 40U}) {  // full vectors and others
    BoxRows rows = cubesAlongX(count);
    setRow(0, 100, {{0, 0.5F, 0.5F, 0}, {100, 0.75F, 0.75F, 0}}, rows);
    std::vector<std::uint32_t> hits(count);
    for (const RowHits found :
         {findBehind(rows, 0, count, hits.data()), findBehindSorted(rows, 0, 0, hits.data())}) {
      ASSERT_EQ(found.count, count - 1);
      for (std::uint32_t i = 1; i < count; ++i) {
        EXPECT_EQ(hits[i - 1], i);
      }
    }
  }
}

TEST(BoxRows, eachCoordinateCanPart) {
  BoxRows rows = cubesAlongX(2);
  std::vector<std::uint32_t> hits(2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    SmallBox above{{0, 0, 0, 0}, {1, 1, 1, 0}};
    above.min[axis] = 1.75F;
    above.max[axis] = 2.0F;
    SmallBox below{{0, 0, 0, 0}, {1, 1, 1, 0}};
    below.min[axis] = -2.0F;
    below.max[axis] = -0.5F;
    for (const SmallBox& box : {above, below}) {
      setRow(0, 0, box, rows);
      EXPECT_EQ(findBehind(rows, 0, 2, hits.data()).count, 0U);
    }
  }
}

TEST(BoxRows, sortedRowsAreLeftAtTheFirstThatBeginsBehind) {
  BoxRows rows = cubesAlongX(1000);
  std::vector<std::uint32_t> hits(1000);
  setRow(5, 0, {{2.5F, 0, 0, 0}, {4.0F, 1, 1, 0}}, rows);  // rows 6, 7 and 8 begin before 4
  const RowHits found = findBehindSorted(rows, 5, 0, hits.data());
  ASSERT_EQ(found.count, 3U);
  EXPECT_EQ(hits[0], 6U);
  EXPECT_EQ(hits[2], 8U);
  EXPECT_LE(found.seen, kRowPadding);
}

TEST(BoxRows, paddingEndsRowsThatHaveNoEnd) {
  BoxRows rows = cubesAlongX(20);
  std::vector<std::uint32_t> hits(20);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  setRow(0, 0, {{-kInfinity, 0, 0, 0}, {kInfinity, 1, 1, 0}}, rows);
  EXPECT_EQ(findBehindSorted(rows, 0, 0, hits.data()).count, 19U);
}

}  // namespace
}  // namespace collision_monitor
