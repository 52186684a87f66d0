// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/box_rows.h"

#include <gtest/gtest.h>

#include <limits>

#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/geometry/ids.h"
#include "support/instruction_sets.h"

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
    std::vector<RowPair> hits(3 * count);  // the first meets all, others at most two behind them
    for (const bool sweeps : {false, true}) {
      const PairedRows found =
          sweeps ? sweepRows(rows, 0, count, 0, hits) : pairRows(rows, 0, count, hits);
      ASSERT_EQ(found.next, count);
      ASSERT_GE(found.count, count - 1);
      for (std::uint32_t i = 1; i < count; ++i) {
        EXPECT_EQ(hits[i - 1].row, 0U);
        EXPECT_EQ(hits[i - 1].other, i);
      }
    }
  }
}

/// Cubes meet the two behind them; the table holds every pair of a cube with an even number, its
/// id 10 times the lower and the upper one.
TEST(BoxRows, ofATable_idsOfPairsThatMeet) {
  for (const std::size_t count : {2U, 5U, 16U, 17U, 18U, 40U}) {
    const BoxRows rows = cubesAlongX(count);
    std::vector<std::uint32_t> ids(count * count + kRowPadding, kNone);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t a = 0; a < count; a += 2) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        ids[a * count + b] = 10 * a + b;
        if (b <= a + 2) {
          expected.push_back(10 * a + b);
        }
      }
    }
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> room(count + kRowPadding);  // as little as may be
    for (std::size_t row = 0; row < count;) {
      const PairedRows paired = pairRowsOfTable(rows, row, count, ids.data(), room);
      ASSERT_GT(paired.next, row);
      row = paired.next;
      found.insert(found.end(), room.begin(),
                   room.begin() + static_cast<std::ptrdiff_t>(paired.count));
    }
    EXPECT_EQ(found, expected);
  }
}

/// Ids are packed in another way on each.
TEST(BoxRows, ofATable_anyLanes_onEveryInstructionSet) {
  constexpr std::size_t kCount = 17;  // one that meets all others
  BoxRows rows = cubesAlongX(kCount);
  setRow(0, 100, {{0, 0.5F, 0.5F, 0}, {100, 0.75F, 0.75F, 0}}, rows);
  for (const std::int64_t target : test::instructionSets()) {
    const test::OnlyInstructionSet only(target);
    for (std::uint32_t eight = 0; eight < 256; ++eight) {
      const std::uint32_t in_table = eight | (~eight & 255U) << 8;
      std::vector<std::uint32_t> ids(kCount * kCount + kRowPadding, kNone);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t other = 1; other < kCount; ++other) {
        if ((in_table >> (other - 1) & 1U) != 0) {
          ids[other] = 1000 + other;
          expected.push_back(1000 + other);
        }
      }
      std::vector<std::uint32_t> found(kCount * kCount);
      found.resize(pairRowsOfTable(rows, 0, kCount, ids.data(), found).count);
      ASSERT_EQ(found, expected) << hwy::TargetName(target);
    }
  }
}

TEST(BoxRows, eachCoordinateCanPart) {
  BoxRows rows = cubesAlongX(2);
  std::vector<RowPair> hits(2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    SmallBox above{{0, 0, 0, 0}, {1, 1, 1, 0}};
    above.min[axis] = 1.75F;
    above.max[axis] = 2.0F;
    SmallBox below{{0, 0, 0, 0}, {1, 1, 1, 0}};
    below.min[axis] = -2.0F;
    below.max[axis] = -0.5F;
    for (const SmallBox& box : {above, below}) {
      setRow(0, 0, box, rows);
      EXPECT_EQ(pairRows(rows, 0, 2, hits).count, 0U);
    }
  }
}

TEST(BoxRows, sortedRowsAreLeftAtTheFirstThatBeginsBehind) {
  BoxRows rows = cubesAlongX(1000);
  std::vector<RowPair> hits(1000);
  setRow(5, 0, {{2.5F, 0, 0, 0}, {4.0F, 1, 1, 0}},
         rows);  // rows 6, 7 and 8 begin before 4 or at it
  const PairedRows found = sweepRows(rows, 5, 1000, 0, hits);
  ASSERT_GT(found.count, 3U);
  EXPECT_EQ(hits[0].row, 5U);
  EXPECT_EQ(hits[0].other, 6U);
  EXPECT_EQ(hits[2].other, 8U);
  EXPECT_EQ(hits[3].row, 6U);
  EXPECT_LE(found.seen, kRowPadding * (found.next - 5));
}

TEST(BoxRows, whereRoomIsScarce_severalCallsFindAll) {
  const BoxRows rows = cubesAlongX(20);  // each meets two behind it, the last two one and none
  std::vector<RowPair> hits(20);
  for (const bool sweeps : {false, true}) {
    std::size_t count = 0;
    std::size_t calls = 0;
    for (std::size_t row = 0; row < 20; ++calls) {
      const PairedRows found =
          sweeps ? sweepRows(rows, row, 20, 0, hits) : pairRows(rows, row, 20, hits);
      ASSERT_GT(found.next, row);
      ASSERT_LE(found.count, hits.size());
      count += found.count;
      row = found.next;
    }
    EXPECT_EQ(count, 37U);
    EXPECT_GT(calls, 1U);
  }
}

TEST(BoxRows, paddingEndsRowsThatHaveNoEnd) {
  BoxRows rows = cubesAlongX(20);
  std::vector<RowPair> hits(100);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  setRow(0, 0, {{-infinity, 0, 0, 0}, {infinity, 1, 1, 0}}, rows);
  EXPECT_EQ(sweepRows(rows, 0, 20, 0, hits).next, 20U);
  EXPECT_EQ(hits[18].row, 0U);
  EXPECT_EQ(hits[18].other, 19U);
}

}  // namespace
}  // namespace collision_monitor
