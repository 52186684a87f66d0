// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/marked_pairs.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

std::vector<PairId> takenFrom(MarkedPairs& marks) {
  std::vector<PairId> pairs{PairId{7}};
  takeMarked(marks, pairs);
  return pairs;
}

TEST(MarkedPairs, nothingIsMarked_atFirst) {
  MarkedPairs marks(1'000'000);
  EXPECT_TRUE(takenFrom(marks).empty());
}

TEST(MarkedPairs, marks_areTakenOnceAndInOrder) {
  MarkedPairs marks(1'000'001);
  for (const std::size_t pair : {1'000'000U, 4'096U, 0U, 4'095U, 64U, 63U, 4'096U}) {
    markPair(pair, marks);
  }
  EXPECT_EQ(takenFrom(marks), (std::vector<PairId>{PairId{0}, PairId{63}, PairId{64}, PairId{4'095},
                                                   PairId{4'096}, PairId{1'000'000}}));
  EXPECT_TRUE(takenFrom(marks).empty());
}

TEST(MarkedPairs, markedWord_isTakenWithItsNeighbours) {
  MarkedPairs marks(64 * 64);
  for (std::size_t pair = 0; pair < 64 * 64; ++pair) {
    markPair(pair, marks);
  }
  EXPECT_EQ(takenFrom(marks).size(), 64U * 64U);
}

}  // namespace
}  // namespace collision_monitor::test
