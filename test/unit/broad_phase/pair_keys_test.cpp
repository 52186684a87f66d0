// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/pair_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace collision_monitor {
namespace {

TEST(PairKeys, lowerBodyStandsFirst) {
  const PairKey key = pairKey(7, 3);
  EXPECT_EQ(key, pairKey(3, 7));
  EXPECT_EQ(lowerBody(key), 3U);
  EXPECT_EQ(upperBody(key), 7U);
  EXPECT_LT(pairKey(3, 900), pairKey(4, 5));
}

TEST(PairKeys, roomIsForAllPairsOfARobot) {
  EXPECT_EQ(roomForPairs(0), 0U);
  EXPECT_GE(roomForPairs(100), 100U * 99 / 2);
  EXPECT_GE(roomForPairs(1000), 1000U * 999 / 2);
  EXPECT_EQ(roomForPairs(100000), 64U * 99000);
}

TEST(PairKeys, orderedBitsOrderAsCoordinatesDo) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float sorted[] = {-infinity, -2.0F, -1.0F, -1e-30F, 0.0F, 1e-30F, 1.0F, 3.5F, infinity};
  for (std::size_t i = 1; i < std::size(sorted); ++i) {
    EXPECT_LT(orderedBits(sorted[i - 1]), orderedBits(sorted[i]));
  }
  EXPECT_EQ(orderedBits(-0.0F), orderedBits(0.0F));
}

TEST(RadixSort, keepsTheOrderOfKeysThatAreEqualInTheBits) {
  std::vector<std::uint64_t> keys{0x201, 0x102, 0x200, 0x101};
  std::vector<std::uint64_t> scratch;
  radixSort({8, 8}, keys, scratch);
  EXPECT_EQ(keys, (std::vector<std::uint64_t>{0x102, 0x101, 0x201, 0x200}));
}

TEST(SortPairs, sortsFewAndManyAsTheLibraryDoes) {
  std::mt19937 random(20260101);
  for (const std::size_t bodies : {2U, 50U, 3000U, 100000U}) {
    for (const std::size_t count : {0U, 10U, 5000U}) {
      std::vector<PairKey> pairs;
      std::vector<PairKey> scratch;
      for (std::size_t i = 0; i < count; ++i) {
        const auto one = static_cast<std::uint32_t>(random() % bodies);
        pairs.push_back(pairKey(one, static_cast<std::uint32_t>(random() % bodies)));
      }
      std::vector<PairKey> expected = pairs;
      std::sort(expected.begin(), expected.end());
      sortPairs(bodies, pairs, scratch);
      EXPECT_EQ(pairs, expected) << bodies << " bodies, " << count << " pairs";
    }
  }
}

}  // namespace
}  // namespace collision_monitor
