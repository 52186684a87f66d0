// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/brute_force.h"

#include <gtest/gtest.h>

#include "boxes_along_x.h"

namespace collision_monitor::test {
namespace {

/// Every two of `bodies`, by (a, b).
std::vector<BodyPair> everyPairOf(std::uint32_t bodies) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t a = 0; a < bodies; ++a) {
    for (std::uint32_t b = a + 1; b < bodies; ++b) {
      pairs.push_back({BodyId{a}, BodyId{b}});
    }
  }
  return pairs;
}

TEST(BruteForce, placesAgainstTheOrderOfBodies_pairsAreSortedByBody) {
  BruteForce method(4);
  const Boxes boxes{boxAlongX(3, 4), boxAlongX(2, 3), boxAlongX(1, 2), boxAlongX(0, 1)};
  EXPECT_EQ(meetingsInOrder(method, boxes), (Meetings{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(BruteForce, moreBodiesThanAVectorHasLanes_eachPairOnce) {
  BruteForce method(40);
  const Meetings found = meetingsInOrder(method, chainOfBoxes(40));
  ASSERT_EQ(found.size(), 39U);
  for (std::uint32_t i = 0; i < 39; ++i) {
    EXPECT_EQ(found[i], (std::pair<std::uint32_t, std::uint32_t>(i, i + 1)));
  }
}

TEST(BruteForce, nothingIsKeptFromCallToCall) {
  BruteForce method(3);
  EXPECT_EQ(meetingsInOrder(method, Boxes(3, boxAlongX(0, 1))).size(), 3U);
  EXPECT_EQ(meetingsInOrder(method, {boxAlongX(0, 1), emptyBox(), boxAlongX(1, 2)}),
            (Meetings{{0, 2}}));
}

TEST(BruteForce, marks_areTheIdsOfPairsThatMeet) {
  const PairTable table({{BodyId{1}, BodyId{2}}, {BodyId{0}, BodyId{2}}, {BodyId{0}, BodyId{1}}},
                        3);
  BruteForce method(3);
  MarkedPairs marks(3);
  method.markPairs({boxAlongX(0, 1), boxAlongX(0.5F, 2), boxAlongX(1.5F, 3)}, table, marks);
  EXPECT_EQ(marks.words[0], 0b101U) << "(1, 2) and (0, 1)";
}

TEST(BruteForce, marks_goOnInTheNextWordAndLeaveOutWhatIsNotInTheTable) {
  std::vector<BodyPair> pairs = everyPairOf(13);
  ASSERT_EQ(pairs.size(), 78U);
  pairs.pop_back();  // (11, 12)
  const PairTable table(pairs, 13);
  BruteForce method(13);
  MarkedPairs marks(77);
  method.markPairs(Boxes(13, boxAlongX(0, 1)), table, marks);
  EXPECT_EQ(marks.words[0], ~std::uint64_t{0});
  EXPECT_EQ(marks.words[1], (std::uint64_t{1} << 13) - 1) << "77 pairs less 64";
}

}  // namespace
}  // namespace collision_monitor::test
